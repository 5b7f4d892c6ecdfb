// See window_style.h.
#include "app/gui/widgets/window_style.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>
#include <QSurfaceFormat>

namespace boxprobe {

void setSurfaceFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  // The widget only copies what VTK drew into buffers of its own; samples of its own would be paid for and not seen.
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

void applyWindowStyle(QApplication& application) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));

  QPalette palette;
  const QColor window(0x2b, 0x2e, 0x33), base(0x1e, 0x20, 0x24), button(0x3a, 0x3e, 0x45);
  const QColor text(0xec, 0xee, 0xf0), dim(0x85, 0x8a, 0x92), accent(0xff, 0xb3, 0x1a);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, QColor(0xf7, 0xf3, 0xe3));
  palette.setColor(QPalette::ToolTipText, QColor(0x1e, 0x20, 0x24));
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, base);
  palette.setColor(QPalette::Link, accent);
  palette.setColor(QPalette::PlaceholderText, dim);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, dim);
  }
  application.setPalette(palette);

  QFont font = application.font();
  constexpr double kSmallestPoints = 10.0;
  if (font.pointSizeF() < kSmallestPoints) font.setPointSizeF(kSmallestPoints);
  application.setFont(font);

  application.setStyleSheet(
      "QGroupBox { font-weight: bold; border: 1px solid #43474e; border-radius: 5px; margin-top: 10px; padding-top: "
      "6px; }"
      "QGroupBox::title { subcontrol-origin: margin; left: 10px; padding: 0 4px; }"
      "QGroupBox QWidget { font-weight: normal; }"
      "QLabel#help { color: #b9bec6; }"
      "QToolTip { color: #1e2024; background: #f7f3e3; border: 1px solid #85754a; padding: 4px; }"
      "QStatusBar::item { border: none; }");
}

}  // namespace boxprobe
