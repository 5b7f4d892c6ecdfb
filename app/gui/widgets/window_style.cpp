// See window_style.h.
#include "app/gui/widgets/window_style.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QSurfaceFormat>
#include <algorithm>
#include <cmath>

namespace boxprobe {

void setSurfaceFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  // The widget only copies what VTK drew into buffers of its own; samples of its own would be paid for and not seen.
  format.setSamples(0);
  format.setOption(QSurfaceFormat::ResetNotification);  // where the driver can tell of a reset, it does
  QSurfaceFormat::setDefaultFormat(format);
}

namespace {

struct Look {
  QColor window, base, button, text, dim, highlight, onHighlight, edge, tip;
  QColor accent, help, good, bad, deciding, remarkable;  ///< StyleColor's, in its order
};

// Contrast of text on its ground: at least 4.5, of what is disabled, too.
const Look kDark = {{0x2b, 0x2e, 0x33}, {0x1e, 0x20, 0x24}, {0x3a, 0x3e, 0x45}, {0xec, 0xee, 0xf0}, {0xa4, 0xa9, 0xb1},
                    {0xff, 0xb3, 0x1a}, {0x1e, 0x20, 0x24}, {0x43, 0x47, 0x4e}, {0x3a, 0x3e, 0x45}, {0xff, 0xb3, 0x1a},
                    {0xb9, 0xbe, 0xc6}, {0x5f, 0xc8, 0x7a}, {0xff, 0x8f, 0x80}, {0x4a, 0x3a, 0x12}, {0x5a, 0x43, 0x12}};
const Look kLight = {{0xee, 0xef, 0xf1}, {0xff, 0xff, 0xff}, {0xe0, 0xe2, 0xe6}, {0x1b, 0x1d, 0x21},
                     {0x5f, 0x64, 0x6c}, {0xff, 0xb3, 0x1a}, {0x1e, 0x20, 0x24}, {0xb9, 0xbd, 0xc4},
                     {0xff, 0xff, 0xff}, {0x8a, 0x56, 0x00}, {0x52, 0x58, 0x61}, {0x1b, 0x75, 0x36},
                     {0xb0, 0x1f, 0x10}, {0xff, 0xe9, 0xb8}, {0xff, 0xdf, 0x99}};

const Look* shown = &kDark;

/// Without a desktop nobody has chosen a light palette: it is Qt's default.
bool desktopIsLight() {
  static const bool light = !qEnvironmentVariableIsEmpty("XDG_CURRENT_DESKTOP") &&
                            QGuiApplication::palette().color(QPalette::Window).lightness() > 127;
  return light;
}

}  // namespace

QColor styleColor(StyleColor color) {
  const QColor* const colors[] = {&shown->accent, &shown->help,     &shown->good,
                                  &shown->bad,    &shown->deciding, &shown->remarkable};
  return *colors[static_cast<int>(color)];
}

double contrast(const QColor& one, const QColor& other) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  };
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

QColor readable(const QColor& color, const QColor& ground) {
  constexpr double kReadable = 4.5;
  constexpr int kStep = 4, kSteps = 64;
  const int way = contrast(Qt::white, ground) > contrast(Qt::black, ground) ? kStep : -kStep;
  QColor text = color;
  for (int i = 0; i < kSteps && contrast(text, ground) < kReadable; ++i) {
    text.setHsl(text.hslHue(), text.hslSaturation(), std::clamp(text.lightness() + way, 0, 255));
  }
  return text;
}

void applyWindowStyle(QApplication& application, Theme theme) {
  const bool systemIsLight = desktopIsLight();  // before the palette becomes our own
  shown = theme == Theme::Light || (theme == Theme::System && systemIsLight) ? &kLight : &kDark;
  const Look& look = *shown;
  if (application.style()->objectName() != "fusion") QApplication::setStyle(QStyleFactory::create("Fusion"));

  QPalette palette;
  palette.setColor(QPalette::Window, look.window);
  palette.setColor(QPalette::WindowText, look.text);
  palette.setColor(QPalette::Base, look.base);
  palette.setColor(QPalette::AlternateBase, look.window);
  palette.setColor(QPalette::Text, look.text);
  palette.setColor(QPalette::Button, look.button);
  palette.setColor(QPalette::ButtonText, look.text);
  palette.setColor(QPalette::BrightText, look.text);
  palette.setColor(QPalette::ToolTipBase, look.tip);
  palette.setColor(QPalette::ToolTipText, look.text);
  palette.setColor(QPalette::Highlight, look.highlight);
  palette.setColor(QPalette::HighlightedText, look.onHighlight);
  palette.setColor(QPalette::Link, look.accent);
  palette.setColor(QPalette::LinkVisited, look.accent);
  palette.setColor(QPalette::PlaceholderText, look.dim);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, look.dim);
  }
  // Fusion draws disabled text a second time in this colour, a pixel aside: it would look bolder than what is enabled.
  palette.setColor(QPalette::Disabled, QPalette::Light, Qt::transparent);
  application.setPalette(palette);
  // The outline of boxes to tick is a darker shade of this colour: darker than the window it is not seen.
  QPalette ticks = palette;
  ticks.setColor(QPalette::Window, look.dim);
  for (const char* kind : {"QMenu", "QCheckBox"}) QApplication::setPalette(ticks, kind);

  QFont font = application.font();
  constexpr double kSmallestPoints = 10.0;
  if (font.pointSizeF() < kSmallestPoints) font.setPointSizeF(kSmallestPoints);
  application.setFont(font);

  application.setStyleSheet(
      QString("QGroupBox { font-weight: bold; border: 1px solid %1; border-radius: 5px; margin-top: 10px; "
              "padding-top: 6px; }"
              "QGroupBox::title { subcontrol-origin: margin; left: 10px; padding: 0 4px; }"
              "QGroupBox QWidget { font-weight: normal; }"
              "QLabel#help { color: %2; }"
              "QLabel#stepTry { color: %3; }"
              "QLabel#taskPraise { color: %4; }"
              "QStatusBar[failed=true] { color: %5; font-weight: bold; }"
              "QToolTip { color: %6; background: %7; border: 1px solid %8; padding: 4px; }"
              // As lists: Fusion draws the choices as menus, on the ground that ticks are made of.
              "QComboBox { combobox-popup: 0; }"
              "QStatusBar::item { border: none; }")
          .arg(look.edge.name(), look.help.name(), look.accent.name(), look.good.name(), look.bad.name())
          .arg(look.text.name(), look.tip.name(), look.dim.name()));
}

}  // namespace boxprobe
