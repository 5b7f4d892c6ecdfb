// See lesson_loops.h.
#include "app/gui/lessons/lesson_loops.h"

#include <QPainter>
#include <QProcess>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/lesson_file.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

constexpr const char* kEncoder = "libvpx-vp9";
constexpr int kQualities[] = {36, 42, 48, 54, 60};  // VP9's scale: 63 is the worst
constexpr int kPanelGap = 4;                        // pixels between panels
constexpr int kPanelHead = 36;                      // for the label
constexpr double kPi = 3.141592653589793;

QString encoderProgram() {
  return QStandardPaths::findExecutable("ffmpeg");
}

/// What it said last, on one line.
std::string lastLine(const QByteArray& said) {
  const QList<QByteArray> lines = said.trimmed().split('\n');
  return lines.isEmpty() ? std::string() : lines.back().trimmed().toStdString();
}

/// Over its panel, as the head of a column: a player's controls lie at the foot, a view's own title at the top.
void label(QPainter& painter, const QRect& head, const std::string& title) {
  QFont font("DejaVu Sans");
  font.setPixelSize(21);
  font.setBold(true);
  painter.setFont(font);
  painter.fillRect(head, QColor("#1d2126"));
  painter.setPen(Qt::white);
  painter.drawText(head, Qt::AlignCenter, QString::fromStdString(title));
}

Camera between(const Camera& from, const Camera& to, double t) {
  Camera camera = from;
  camera.position = from.position + t * (to.position - from.position);
  camera.target = from.target + t * (to.target - from.target);
  camera.verticalFovDegrees += t * (to.verticalFovDegrees - from.verticalFovDegrees);
  return camera;
}

void requireLoop(const Lesson& lesson, const LessonLoop& loop) {
  for (const std::size_t step : loop.steps) {
    if (step >= lesson.steps.size()) {
      throw InputError("page.json: loop " + loop.name + ": lesson " + lesson.name + " has no step " +
                       std::to_string(step + 1) + "; there are " + std::to_string(lesson.steps.size()));
    }
    for (const double t : {0.0, 1.0}) {
      Scene scene = lessonScene(lesson, step);
      for (const LessonLoop::Field& field : loop.fields) setSceneFields(scene, {field.at(t)});
    }
  }
}

QImage drawPanels(LessonPhotographer& photographer, Lesson& lesson, const LessonLoop& loop, double t) {
  std::vector<std::string> changes;
  for (const LessonLoop::Field& field : loop.fields) changes.push_back(field.at(t));
  std::vector<QImage> panels;
  for (const std::size_t index : loop.steps) {
    LessonStep& step = lesson.steps[index];
    step.boxes = step.boxes || loop.boxes;
    if (!loop.walk.empty()) {
      step.cameraName.clear();
      step.camera = between(loop.walk[0], loop.walk[1], t);
    }
    photographer.player().showChanged(index, changes);
    LessonStep bare = step;
    bare.rays.clear();  // a changed scene is shown without rays, so it gets no letters either
    bare.inset.reset();
    panels.push_back(photographer.picture(bare));
  }
  const int width = panels.front().width(), count = static_cast<int>(panels.size());
  // VP9 wants even sizes.
  QImage picture((count * width + (count - 1) * kPanelGap) & ~1, (kPanelHead + panels.front().height()) & ~1,
                 QImage::Format_RGB888);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::TextAntialiasing);
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int left = i * (width + kPanelGap);
    painter.drawImage(left, kPanelHead, panels[at]);
    label(painter, QRect(left, 0, width, kPanelHead), loop.labels[at]);
  }
  return picture;
}

/// One run of the encoder over all pictures, into a file.
void encodeOnce(const std::vector<QImage>& pictures, const std::string& file, int quality) {
  const QSize size = pictures.front().size();
  QProcess process;
  process.start(encoderProgram(), {"-hide_banner",
                                   "-loglevel",
                                   "error",
                                   "-nostdin",
                                   "-f",
                                   "rawvideo",
                                   "-pixel_format",
                                   "rgb24",
                                   "-video_size",
                                   QString("%1x%2").arg(size.width()).arg(size.height()),
                                   "-framerate",
                                   QString::number(kLoopRate),
                                   "-i",
                                   "pipe:0",
                                   "-an",
                                   "-c:v",
                                   kEncoder,
                                   "-pix_fmt",
                                   "yuv420p",
                                   "-b:v",
                                   "0",
                                   "-crf",
                                   QString::number(quality),
                                   "-deadline",
                                   "good",
                                   "-cpu-used",
                                   "2",
                                   "-g",
                                   "999",
                                   "-f",
                                   "webm",
                                   "-y",
                                   QString::fromStdString(file)});
  if (!process.waitForStarted()) throw WorkError("ffmpeg could not be started: " + process.errorString().toStdString());
  for (const QImage& picture : pictures) {
    for (int y = 0; y < picture.height(); ++y) {
      process.write(reinterpret_cast<const char*>(picture.constScanLine(y)), 3 * picture.width());
    }
    while (process.bytesToWrite() > 0 && process.waitForBytesWritten(-1)) {
    }
  }
  process.closeWriteChannel();
  process.waitForFinished(-1);
  if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0) {
    throw WorkError("ffmpeg failed: " + lastLine(process.readAllStandardError()));
  }
}

}  // namespace

void requireLoopEncoder() {
  const std::string advice = "; it encodes the loops. Install it (Debian: apt-get install ffmpeg) and run this again";
  if (encoderProgram().isEmpty()) throw InputError("--loops: there is no ffmpeg on the PATH" + advice);
  QProcess process;
  process.start(encoderProgram(), {"-hide_banner", "-loglevel", "error", "-encoders"});
  process.waitForFinished(-1);
  if (!process.readAllStandardOutput().contains(kEncoder)) {
    throw InputError("--loops: this ffmpeg has no " + std::string(kEncoder) + advice);
  }
}

std::vector<QImage> drawLoop(LessonPhotographer& photographer, const Lesson& lesson, const LessonLoop& loop,
                             const std::function<void(double)>& drawn) {
  requireLoop(lesson, loop);
  Lesson moving = lesson;  // its steps take the camera of each picture
  photographer.open(moving);
  const int count = std::max(2, static_cast<int>(std::lround(loop.seconds * kLoopRate)));
  std::vector<QImage> pictures(static_cast<std::size_t>(count));
  for (int i = 0; i <= count / 2; ++i) {
    const double t = 0.5 - 0.5 * std::cos(2.0 * kPi * i / count);
    pictures[static_cast<std::size_t>(i)] = drawPanels(photographer, moving, loop, t);
    // The way back is the way there.
    pictures[static_cast<std::size_t>((count - i) % count)] = pictures[static_cast<std::size_t>(i)];
    drawn(static_cast<double>(i + 1) / (count / 2 + 1));
  }
  photographer.open(lesson);
  return pictures;
}

void encodeLoop(const std::vector<QImage>& pictures, const std::string& path) {
  writeAtomically(path, [&](const std::string& temporary) {
    std::uintmax_t size = 0;
    for (const int quality : kQualities) {
      encodeOnce(pictures, temporary, quality);
      size = std::filesystem::file_size(temporary);
      if (size <= kLargestLoop) return;
    }
    throw WorkError(path + ": " + std::to_string(size) + " bytes at the lowest quality; at most " +
                    std::to_string(kLargestLoop) + " are meant: make the loop shorter");
  });
}

}  // namespace boxprobe
