// A loop as a file: as sharp as it may be, and no file where even the least sharp one is too large. The encoder is a
// program of the test's own that writes as many bytes as the asked quality is worth here.
#include "app/gui/lessons/lesson_loops.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "filters/core/base/errors.h"

namespace boxprobe {
namespace {

namespace fs = std::filesystem;

/// Puts an `ffmpeg` before all others for as long as it lives: `bytesFor36` at quality 36, 10,000 less for each step.
class StandInEncoder {
 public:
  explicit StandInEncoder(long bytesFor36) {
    const fs::path program = fs::path(folder_.path().toStdString()) / "ffmpeg";
    std::ofstream(program) << "#!/bin/sh\n"
                           << "cat >/dev/null\n"
                           << "while [ $# -gt 1 ]; do if [ \"$1\" = -crf ]; then quality=$2; fi; shift; done\n"
                           << "echo $quality >>\"" << asked() << "\"\n"
                           << "head -c $((" << bytesFor36 << " - 10000 * (quality - 36))) /dev/zero >\"$1\"\n";
    fs::permissions(program, fs::perms::owner_all);
    qputenv("PATH", (folder_.path() + ":" + QString::fromLocal8Bit(before_)).toLocal8Bit());
  }
  ~StandInEncoder() { qputenv("PATH", before_); }

  std::string loop() const { return (fs::path(folder_.path().toStdString()) / "loop.webm").string(); }
  std::vector<int> qualities() const {
    std::ifstream file(asked());
    return {std::istream_iterator<int>(file), std::istream_iterator<int>()};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path().toStdString()), {}));
  }

 private:
  std::string asked() const { return (fs::path(folder_.path().toStdString()) / "asked").string(); }
  QTemporaryDir folder_;
  QByteArray before_ = qgetenv("PATH");
};

std::vector<QImage> twoPictures() {
  QImage dark(34, 18, QImage::Format_RGB888), bright(34, 18, QImage::Format_RGB888);
  dark.fill(QColor(10, 20, 30));
  bright.fill(QColor(230, 210, 190));
  return {dark, bright};
}

TEST(LessonLoops, TakeTheSharpestQualityThatFits) {
  const StandInEncoder large(kLargestLoop + 65001);
  encodeLoop(twoPictures(), large.loop());
  EXPECT_EQ(large.qualities(), (std::vector<int>{36, 42, 48})) << "each lower one only if it has to be";
  EXPECT_EQ(fs::file_size(large.loop()), kLargestLoop + 65001 - 120000);
}

TEST(LessonLoops, OfExactlyTheLargestSizeFit) {
  const StandInEncoder encoder(kLargestLoop);
  encodeLoop(twoPictures(), encoder.loop());
  EXPECT_EQ(encoder.qualities(), std::vector<int>{36});
  EXPECT_EQ(fs::file_size(encoder.loop()), kLargestLoop);
}

TEST(LessonLoops, ThatAreTooLongLeaveTheOldFile) {
  const StandInEncoder encoder(kLargestLoop + 240001);
  std::ofstream(encoder.loop()) << "an older loop";
  const std::size_t files = encoder.files();
  try {
    encodeLoop(twoPictures(), encoder.loop());
    FAIL() << "a byte more than may be";
  } catch (const WorkError& error) {
    EXPECT_NE(std::string(error.what()).find("1000001 bytes"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("make the loop shorter"), std::string::npos) << error.what();
  }
  EXPECT_EQ(encoder.qualities().size(), 5u);
  EXPECT_EQ(fs::file_size(encoder.loop()), 13u);
  EXPECT_EQ(encoder.files(), files + 1) << "the list of asked qualities, and nothing half written";
}

}  // namespace
}  // namespace boxprobe
