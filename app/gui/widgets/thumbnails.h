// Small pictures of the scenes that were opened, in the user's cache folder, by the scene's path. One that is missing
// or broken is no picture, and one that cannot be written is not kept: nobody is told of either.
#pragma once

#include <QImage>
#include <QSize>
#include <QString>

namespace boxprobe {

/// As it is shown, logical pixels.
constexpr QSize kThumbnailSize(176, 110);

/// Where that of `scene` is kept, whether or not it is there.
QString thumbnailPath(const QString& scene);
/// The middle of `picture`, scaled down. The oldest of many are removed.
void keepThumbnail(const QString& scene, const QImage& picture);
/// Null unless `path` is a picture of at most 1024 x 1024.
QImage readThumbnail(const QString& path);

}  // namespace boxprobe
