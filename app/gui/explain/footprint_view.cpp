// See footprint_view.h.
#include "app/gui/explain/footprint_view.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/gui/explain/explanation_html.h"
#include "filters/core/base/fixed_text.h"
#include "filters/explain/explanation_sections.h"

namespace boxprobe {

namespace {

const QColor kMark(255, 179, 26);
const QColor kMarkRim(10, 12, 16);
constexpr float kSmallestShare = 1e-3f;  ///< less is not outlined: nothing of it can be seen in the colour

struct Texel {
  TexelShare texel;
  float share = 0.0f;  ///< of the technique's value
};

/// All fetches together: a texel fetched twice has the sum of its shares.
std::vector<Texel> sharesByTexel(const ProbeExplanation& probe) {
  std::map<std::array<int, 4>, float> sums;
  for (const Lookup& lookup : probe.lookups) {
    for (const TexelShare& t : lookup.texels) sums[{t.level, t.face, t.column, t.row}] += lookup.weight * t.share;
  }
  std::vector<Texel> texels;
  for (const auto& [key, share] : sums) {
    texels.push_back({{key[0], key[1], key[2], key[3], share}, share});
  }
  return texels;
}

QImage imageOf(const ImageRgba8& picture) {
  const QImage view(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                    4 * picture.width, QImage::Format_RGBA8888);
  return view.copy();
}

/// A line that reads on any picture: a dark rim under the colour.
void drawRimmed(QPainter& painter, const QPolygonF& outline, double width) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kMarkRim, width + 2.0));
  painter.drawPolygon(outline);
  painter.setPen(QPen(kMark, width));
  painter.drawPolygon(outline);
}

}  // namespace

FootprintView::FootprintView(QWidget* parent) : QWidget(parent) {
  setObjectName("footprint");
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setMinimumSize(240, 220);
  setToolTip(
      tr("The probe's cubemap, unfolded and seen from inside: +Z in the middle, +X to its left. Outlined: the texels "
         "that this pixel samples, magnified at the right with their shares in percent."));
}

void FootprintView::show(const ProbeExplanation& probe, std::shared_ptr<const BakedMaps> maps, double exposure) {
  probe_ = probe;
  maps_ = std::move(maps);
  exposure_ = exposure;
  std::map<int, float> byLevel;
  main_ = TexelShare();
  for (const Texel& t : sharesByTexel(probe)) {
    byLevel[t.texel.level] += t.share;
    if (t.share > main_.share) main_ = t.texel;
  }
  level_ = 0;
  for (const auto& [level, share] : byLevel) {
    if (share > byLevel[level_]) level_ = level;
  }
  update();
}

void FootprintView::clear() {
  probe_ = ProbeExplanation();
  maps_.reset();
  update();
}

void FootprintView::redraw(int width) {
  const Drawn wanted{maps_, level_, width, exposure_};
  if (drawn_.maps == wanted.maps && drawn_.level == wanted.level && drawn_.width == wanted.width &&
      drawn_.exposure == wanted.exposure) {
    return;
  }
  drawn_ = wanted;
  picture_ = imageOf(drawCubePicture(maps_->radiance, level_, CubePicture(CubePictureKind::Cross, width),
                                     static_cast<float>(exposure_)));
}

void FootprintView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!maps_ || maps_->radiance.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        rect(), Qt::AlignCenter | Qt::TextWordWrap,
        probe_.name.empty() ? QString() : tr("%1 has no cubemap yet").arg(QString::fromStdString(probe_.name)));
    return;
  }
  const double ratio = devicePixelRatioF();
  const double widest = std::min(static_cast<double>(width()), height() * 4.0 / 3.0);
  const CubePicture picture(CubePictureKind::Cross, static_cast<int>(widest * ratio));
  redraw(picture.width());
  const double scale = 1.0 / ratio;
  const QPointF corner(0.5 * (width() - picture.width() * scale), 0.0);
  painter.drawImage(QRectF(corner, QSizeF(picture.width() * scale, picture.height() * scale)), picture_);
  paintTexels(painter, picture, corner, scale);
  // A cross leaves two by one faces free at the upper and the lower right.
  const double face = 0.25 * picture.width() * scale;
  const double gap = 4.0;
  paintMagnifier(painter, {corner.x() + 3.0 * face - 0.5 * face, 0.0, face - gap, face - gap});
  paintCaption(painter, {corner.x() + 2.0 * face + 2.0 * gap, 2.0 * face + gap, 2.0 * face - 2.0 * gap, face - gap});
}

void FootprintView::paintTexels(QPainter& painter, const CubePicture& picture, const QPointF& corner,
                                double scale) const {
  QRectF around;
  for (const Texel& t : sharesByTexel(probe_)) {
    if (t.share < kSmallestShare) continue;
    QPolygonF outline;
    const int size = maps_->radiance.levelSize(t.texel.level);
    for (const glm::dvec2& p : picture.texelOutline(size, t.texel.face, t.texel.column, t.texel.row)) {
      outline << corner + scale * QPointF(p.x, p.y);
    }
    drawRimmed(painter, outline, t.texel.level == level_ ? 1.5 : 1.0);
    if (t.texel.level == main_.level && t.texel.face == main_.face) around |= outline.boundingRect();
  }
  // Texels may be smaller than a pixel: a ring says where they are.
  constexpr double kSmallestSeen = 10.0;
  if (around.isNull() || std::max(around.width(), around.height()) > kSmallestSeen) return;
  for (const auto& [color, width] : {std::pair(kMarkRim, 4.0), std::pair(kMark, 2.0)}) {
    painter.setPen(QPen(color, width));
    painter.drawEllipse(around.center(), kSmallestSeen, kSmallestSeen);
  }
}

void FootprintView::paintMagnifier(QPainter& painter, const QRectF& area) const {
  if (main_.share <= 0.0f) return;
  const CubeMap& map = maps_->radiance;
  const int size = map.levelSize(main_.level);
  int low[2] = {main_.column, main_.row}, high[2] = {main_.column, main_.row};
  std::map<std::pair<int, int>, float> shares;
  for (const Texel& t : sharesByTexel(probe_)) {
    if (t.texel.level != main_.level || t.texel.face != main_.face || t.share < kSmallestShare) continue;
    shares[{t.texel.column, t.texel.row}] = t.share;
    const int at[2] = {t.texel.column, t.texel.row};
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
    }
  }
  constexpr int kFewest = 4, kMost = 24;
  const int cells = std::clamp(std::max(high[0] - low[0], high[1] - low[1]) + 3, kFewest, kMost);
  const int first[2] = {(low[0] + high[0] + 1 - cells) / 2, (low[1] + high[1] + 1 - cells) / 2};
  const double cell = area.width() / cells;
  painter.setPen(Qt::NoPen);
  const auto rectOf = [&](int column, int row) {
    // Seen from inside, as in the cross: columns run from right to left.
    return QRectF(area.right() - (column - first[0] + 1) * cell, area.top() + (row - first[1]) * cell, cell, cell);
  };
  for (int row = first[1]; row < first[1] + cells; ++row) {
    for (int column = first[0]; column < first[0] + cells; ++column) {
      // Beyond the face's edge the neighbouring face goes on.
      const float s = 2.0f * (static_cast<float>(column) + 0.5f) / static_cast<float>(size) - 1.0f;
      const float t = 2.0f * (static_cast<float>(row) + 0.5f) / static_cast<float>(size) - 1.0f;
      const CubePoint p = cubePoint(shading::cubeDirection(main_.face, s, t));
      const auto index = [size](float x) {
        return std::clamp(static_cast<int>(0.5f * (x + 1.0f) * static_cast<float>(size)), 0, size - 1);
      };
      const glm::vec3 color(map.texel(main_.level, p.face, index(p.s), index(p.t)));
      painter.fillRect(rectOf(column, row).adjusted(0.0, 0.0, 0.5, 0.5), displayColor(color, exposure_));
    }
  }
  QFont font = painter.font();
  font.setPointSizeF(std::min(font.pointSizeF(), 0.32 * cell));
  constexpr double kLegiblePoints = 5.5;
  for (const auto& [at, share] : shares) {
    const QRectF box = rectOf(at.first, at.second);
    drawRimmed(painter, QPolygonF(box), 1.5);
    if (font.pointSizeF() < kLegiblePoints) continue;
    painter.setFont(font);
    const QString text = QString::number(static_cast<int>(std::lround(100.0f * share)));
    const glm::vec3 color(map.texel(main_.level, main_.face, at.first, at.second));
    painter.setPen(displayColor(color, exposure_).lightness() > 140 ? Qt::black : Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kMark, 1.5));
  painter.drawRect(area);
}

void FootprintView::paintCaption(QPainter& painter, const QRectF& area) const {
  QFont font = painter.font();
  constexpr double kShareOfHeight = 0.145;
  font.setPixelSize(std::clamp(static_cast<int>(kShareOfHeight * area.height()), 9, 15));
  painter.setFont(font);
  painter.setPen(palette().color(QPalette::Text));
  const int size = maps_->radiance.levelSize(level_);
  QString text = tr("%1\nmip level %2 of %3: %4² texels per face")
                     .arg(QString::fromStdString(probe_.name))
                     .arg(level_)
                     .arg(fixedText(probe_.maxLevel, 0).c_str())
                     .arg(size);
  if (probe_.lookups.empty()) {
    text += tr("\nno lookups here");
  } else {
    const auto count = probe_.lookups.size();
    text += count == 1 ? tr("\none lookup, on face %1").arg(cubeFaceName(main_.face).c_str())
                       : tr("\n%1 lookups, most on face %2").arg(count).arg(cubeFaceName(main_.face).c_str());
  }
  painter.drawText(area, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, text);
}

}  // namespace boxprobe
