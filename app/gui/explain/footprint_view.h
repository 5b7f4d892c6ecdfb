// The cubemap of the probe that is explained, unfolded as a cross, with the texels that were fetched outlined on it and
// magnified in the corner that a cross leaves free. Called by the explain card; paints, computes no lookup.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "filters/core/picture/baked_probe.h"
#include "filters/core/picture/cube_picture.h"
#include "filters/explain/explanation.h"

namespace boxprobe {

class FootprintView : public QWidget {
  Q_OBJECT

 public:
  explicit FootprintView(QWidget* parent = nullptr);

  /// `maps` may be null (not captured): the view then says so.
  void show(const ProbeExplanation& probe, std::shared_ptr<const BakedMaps> maps, double exposure);
  void clear();

  QSize sizeHint() const override { return {384, 288}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return 3 * width / 4; }

  /// Which level is shown: the one with the largest share of the lookups.
  int level() const { return level_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// What the picture was drawn from; it is drawn again only if that differs.
  struct Drawn {
    std::shared_ptr<const BakedMaps> maps;
    int level = -1;
    int width = 0;  ///< device pixels
    double exposure = 0.0;
  };

  void redraw(int width);
  void paintTexels(QPainter& painter, const CubePicture& picture, const QPointF& corner, double scale) const;
  void paintMagnifier(QPainter& painter, const QRectF& area) const;
  void paintCaption(QPainter& painter, const QRectF& area) const;

  ProbeExplanation probe_;
  std::shared_ptr<const BakedMaps> maps_;
  double exposure_ = 1.0;
  int level_ = 0;
  TexelShare main_;  ///< the texel with the largest share
  Drawn drawn_;
  QImage picture_;
};

}  // namespace boxprobe
