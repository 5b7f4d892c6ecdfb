// How far two pictures of one view are apart, pixel by pixel: as numbers and as a picture in false colours. Called by
// the comparisons; knows two images, no scene.
#pragma once

#include <QColor>
#include <QImage>
#include <QString>
#include <optional>

#include "filters/reference/light/progressive_picture.h"

namespace boxprobe {

/// Peak signal-to-noise ratio of display colours, dB, over all pixels; infinite for equal ones. Sizes must be equal.
double displayPsnr(const QImage& a, const QImage& b);

struct PictureDifference {
  QImage picture;         ///< differenceColor() of each pixel
  double mean = 0.0;      ///< of all pixels; differences go from 0 to 1, black against white
  double mostOf95 = 0.0;  ///< 95 % of the pixels are no further apart
};

/// The difference of a pixel is the largest of its display colours' channels. Sizes must be equal.
PictureDifference pictureDifference(const QImage& a, const QImage& b);

/// What a picture's light is off, as `bench --whole` measures it: linear, so that bright pixels count as they are.
struct LightDifference {
  double light = 1.0;         ///< its mean over the truth's
  double relativeRmse = 0.0;  ///< the truth's noise taken off
  double noise = 0.0;         ///< of the truth, in the same measure
};
/// Nothing if the sizes differ.
std::optional<LightDifference> lightDifference(const ImageRgbaF& picture, const ReferencePicture& truth);
/// "light 0.96, RMSE 0.14", and ", noise 0.03" where that is more than a tenth of the RMSE.
QString lightText(const LightDifference& difference);

/// As differenceBytes() has it.
QColor differenceColor(double difference);

}  // namespace boxprobe
