// The two looks of the window: what is written can be read.
#include "app/gui/widgets/window_style.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QPalette>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/gui/widgets/axis_colors.h"

namespace {

using namespace boxprobe;

/// Contrast of two colours by WCAG 2.1: from 1 to 21.
double contrastByWcag(const QColor& one, const QColor& other) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  };
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

TEST(WindowStyle, EachThemeIsThePaletteOfTheWindowAndCanBeRead) {
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    applyWindowStyle(*qApp, theme);
    const QPalette palette = QApplication::palette();
    SCOPED_TRACE(theme == Theme::Light ? "light" : "dark");
    EXPECT_EQ(palette.color(QPalette::Window).lightness() > 127, theme == Theme::Light);
    EXPECT_EQ(palette.color(QPalette::Base).lightness() > 127, theme == Theme::Light);
    const std::pair<QPalette::ColorRole, QPalette::ColorRole> written[] = {
        {QPalette::WindowText, QPalette::Window},
        {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},
        {QPalette::ButtonText, QPalette::Button},
        {QPalette::ToolTipText, QPalette::ToolTipBase},
        {QPalette::HighlightedText, QPalette::Highlight},
        {QPalette::PlaceholderText, QPalette::Base},
        {QPalette::Link, QPalette::Window},
        {QPalette::Link, QPalette::Base},
        {QPalette::LinkVisited, QPalette::Base},
        {QPalette::BrightText, QPalette::Button},
        {QPalette::WindowText, QPalette::Base},
        {QPalette::Text, QPalette::Window},
        {QPalette::ButtonText, QPalette::Window},
    };
    // Of what is disabled, too.
    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled}) {
      for (const auto& [text, ground] : written) {
        EXPECT_GE(contrastByWcag(palette.color(group, text), palette.color(group, ground)), 4.5)
            << "roles " << text << " on " << ground << ", group " << group;
      }
    }
    for (const StyleColor color : {StyleColor::Accent, StyleColor::Dim, StyleColor::Good, StyleColor::Bad}) {
      for (const QPalette::ColorRole ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase}) {
        EXPECT_GE(contrastByWcag(styleColor(color), palette.color(ground)), 4.5) << static_cast<int>(color);
      }
    }
    for (const StyleColor ground : {StyleColor::Deciding, StyleColor::Remarkable}) {
      EXPECT_GE(contrastByWcag(palette.color(QPalette::Text), styleColor(ground)), 4.5) << static_cast<int>(ground);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const QColor ground = palette.color(QPalette::Window);
      EXPECT_GE(contrastByWcag(readable(axisColor(axis), ground), ground), 4.5) << axis;
    }
  }
}

/// As it is seen: the ground is what most pixels are, the letters what differs most from it.
double seenContrast(const QImage& picture) {
  std::map<QRgb, int> counts;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) ++counts[picture.pixel(x, y)];
  }
  const auto ground =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  double most = 1.0;
  for (const auto& [color, count] : counts) most = std::max(most, contrastByWcag(QColor(color), QColor(ground->first)));
  return most;
}

TEST(WindowStyle, ChoicesOfADropdownCanBeRead) {
  for (const Theme theme : {Theme::Light, Theme::Dark}) {
    applyWindowStyle(*qApp, theme);
    QComboBox combo;
    combo.addItems({"mmmmmmmm", "nnnnnnnn", "oooooooo", "wwwwwwww"});
    combo.show();
    combo.showPopup();
    QCoreApplication::processEvents();
    const QWidget* list = combo.view()->viewport();
    const QImage seen = const_cast<QWidget*>(list)->grab().toImage();
    if (const QString folder = qEnvironmentVariable("BOXPROBE_TEST_OUTPUT"); !folder.isEmpty()) {
      seen.save(folder + (theme == Theme::Light ? "/choices-light.png" : "/choices-dark.png"));
    }
    // Below the chosen one, which has the highlight for its ground.
    const QRect second = combo.view()->visualRect(combo.model()->index(2, 0));
    EXPECT_GE(seenContrast(seen.copy(second)), 4.5) << (theme == Theme::Light ? "light" : "dark");
    combo.hidePopup();
  }
}

}  // namespace
