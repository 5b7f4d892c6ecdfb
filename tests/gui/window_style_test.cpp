// The two looks of the window: what is written can be read.
#include "app/gui/widgets/window_style.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPalette>
#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using namespace boxprobe;

/// Contrast of two colours by WCAG 2.1: from 1 to 21.
double contrast(const QColor& one, const QColor& other) {
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
        {QPalette::WindowText, QPalette::Window},       {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},      {QPalette::ButtonText, QPalette::Button},
        {QPalette::ToolTipText, QPalette::ToolTipBase}, {QPalette::HighlightedText, QPalette::Highlight},
    };
    for (const auto& [text, ground] : written) {
      EXPECT_GE(contrast(palette.color(text), palette.color(ground)), 4.5) << "roles " << text << " on " << ground;
    }
    for (const StyleColor color : {StyleColor::Accent, StyleColor::Dim, StyleColor::Good, StyleColor::Bad}) {
      EXPECT_GE(contrast(styleColor(color), palette.color(QPalette::Window)), 4.5) << static_cast<int>(color);
    }
  }
}

}  // namespace
