// See kept_pictures.h.
#include "tests/gui/kept_pictures.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFontMetrics>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "tests/support/kept_values.h"

namespace boxprobe {

namespace {

constexpr int kCells = 24;  ///< across and down

using Cell = std::array<int, 3>;

Cell meanOf(const QImage& colors, const QRect& area) {
  Cell sum{};
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x) {
      const QRgb at = colors.pixel(x, y);
      sum[0] += qRed(at), sum[1] += qGreen(at), sum[2] += qBlue(at);
    }
  }
  for (int& channel : sum) channel /= area.width() * area.height();
  return sum;
}

/// As cellColors() writes them. `size` gets the rest.
std::vector<Cell> cellsOf(const std::string& text, QString& size) {
  QStringList words = QString::fromStdString(text).split(' ');
  std::vector<Cell> cells;
  size = words.value(0) + " " + words.value(1);
  for (const QString& word : words.mid(2)) {
    Cell cell;
    for (int c = 0; c < 3; ++c) cell[static_cast<std::size_t>(c)] = word.mid(2 * c, 2).toInt(nullptr, 16);
    const int times = word.contains('x') ? word.section('x', 1).toInt() : 1;
    cells.insert(cells.end(), static_cast<std::size_t>(std::clamp(times, 0, kCells * kCells)), cell);
  }
  return cells;
}

/// Width, height, and the colour of each cell, two hexadecimal digits a channel; "x3" behind what stands three times in
/// a row.
std::string cellColors(const QImage& image) {
  const QImage colors = image.convertToFormat(QImage::Format_RGB32);
  QString text = QString("%1 %2").arg(image.width()).arg(image.height());
  QString last;
  int times = 0;
  const auto write = [&] {
    if (times > 0) text += " " + last + (times > 1 ? QString("x%1").arg(times) : QString());
    times = 0;
  };
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const int left = column * image.width() / kCells, top = row * image.height() / kCells;
      const int right = std::max((column + 1) * image.width() / kCells, left + 1),
                bottom = std::max((row + 1) * image.height() / kCells, top + 1);
      const Cell cell = meanOf(colors, QRect(left, top, right - left, bottom - top));
      QString digits;
      for (const int channel : cell) digits += QString("%1").arg(channel, 2, 16, QChar('0'));
      if (digits != last) write();
      last = digits;
      ++times;
    }
  }
  write();
  return text.toStdString();
}

/// All, if the sizes differ.
int differingCells(const std::string& now, const std::string& before, int most) {
  QString sizes[2];
  const std::vector<Cell> a = cellsOf(now, sizes[0]), b = cellsOf(before, sizes[1]);
  if (sizes[0] != sizes[1] || a.size() != b.size()) return kCells * kCells;
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    bool same = true;
    for (std::size_t c = 0; c < 3; ++c) same = same && std::abs(a[i][c] - b[i][c]) <= most;
    count += same ? 0 : 1;
  }
  return count;
}

/// Widths of letters and the version of Qt: pictures with words differ where this does.
std::string fontsNow() {
  const QFontMetrics own(QFont("DejaVu Sans", 9)), window(QApplication::font());
  const QString words = "A ray leaves at 0.123, \xce\xb8";
  return std::to_string(own.horizontalAdvance(words)) + " " + std::to_string(window.horizontalAdvance(words)) + " " +
         std::to_string(window.height()) + " " + qVersion();
}

}  // namespace

void expectKeptPictures(const std::string& file, const std::map<std::string, QImage>& pictures,
                        const std::map<std::string, std::string>& texts, int most) {
  if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
    for (const auto& [name, image] : pictures)
      image.save(QString("%1/%2.png").arg(folder, QString::fromStdString(name)));
  }
  std::vector<std::string> lines = {"fonts: " + fontsNow()};
  for (const auto& [name, text] : texts) lines.push_back("text " + name + ": " + text);
  for (const auto& [name, image] : pictures) lines.push_back("picture " + name + ": " + cellColors(image));
  if (test::writesKept(file, lines)) return;
  std::map<std::string, std::string> kept;
  for (const std::string& line : test::keptLines(file)) {
    const std::size_t colon = line.find(": ");
    ASSERT_NE(colon, std::string::npos) << line.substr(0, 60);
    kept[line.substr(0, colon)] = line.substr(colon + 2);
  }
  EXPECT_EQ(kept.size(), lines.size()) << file;
  for (const auto& [name, text] : texts) EXPECT_EQ(text, kept["text " + name]) << name;
  if (kept["fonts"] != fontsNow()) {
    GTEST_SKIP() << "other fonts or another Qt than the file was written with: " << fontsNow() << ", not "
                 << kept["fonts"];
  }
  for (const auto& [name, image] : pictures) {
    EXPECT_EQ(differingCells(cellColors(image), kept["picture " + name], most), 0) << name << ": cells that differ";
  }
}

}  // namespace boxprobe
