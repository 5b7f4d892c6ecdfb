// See thumbnails.h.
#include "app/gui/widgets/thumbnails.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QSaveFile>
#include <QStandardPaths>

namespace boxprobe {

namespace {

constexpr int kMostKept = 40;
constexpr int kFine = 2;  ///< for screens of twice the pixels

QString folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation)).filePath("boxprobe/thumbnails");
}

void removeOldest() {
  QDir kept(folder());
  const QStringList names = kept.entryList({"*.jpg"}, QDir::Files, QDir::Time);
  for (int i = kMostKept; i < names.size(); ++i) kept.remove(names[i]);
}

}  // namespace

QString thumbnailPath(const QString& scene) {
  const QByteArray path = QFileInfo(scene).absoluteFilePath().toUtf8();
  return QDir(folder()).filePath(QCryptographicHash::hash(path, QCryptographicHash::Sha1).toHex() + ".jpg");
}

void keepThumbnail(const QString& scene, const QImage& picture) {
  if (picture.isNull()) return;
  const QSize size = kFine * kThumbnailSize;
  const QImage scaled = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QRect middle(QPoint((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2), size);
  QDir().mkpath(folder());
  QFile::setPermissions(folder(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  QSaveFile file(thumbnailPath(scene));
  if (!file.open(QIODevice::WriteOnly)) return;
  constexpr int kQuality = 85;
  if (!scaled.copy(middle).convertToFormat(QImage::Format_RGB32).save(&file, "JPG", kQuality)) return;
  file.commit();
  removeOldest();
}

QImage readThumbnail(const QString& path) {
  constexpr int kLargest = 1024;
  QImageReader reader(path);
  const QSize size = reader.size();
  if (!size.isValid() || size.width() > kLargest || size.height() > kLargest) return {};
  return reader.read();
}

}  // namespace boxprobe
