// Damaged, hostile and unwritable files of cubes: one line, no crash, no memory asked for by a header, no partial file.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <limits>

#include "filters/io/image/exr_writer.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class CubeDamage : public TemporaryFolder {
 protected:
  /// Both readers on these bytes: they may succeed (a byte that changes a value) or refuse in one line; nothing else.
  /// The number of refusals.
  int readBoth(const std::string& bytes) const {
    const std::string path = write("damaged.exr", bytes);
    int refused = 0;
    for (const bool baked : {true, false}) {
      try {
        baked ? static_cast<void>(loadBakedProbe(path)) : static_cast<void>(loadCube(path));
      } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_EQ(text.rfind(path, 0), 0u) << text;
        ++refused;
      }
    }
    bakedProbeMark(path);
    return refused;
  }

  std::string validFile() const {
    BakedProbeFile probe;
    probe.maps.radiance = noisyHalfCube(16, 5);
    probe.maps.distance = smoothCube(16);
    probe.info.inputHash = "hash";
    saveBakedProbe(file("valid.exr"), probe);
    return read("valid.exr");
  }
};

TEST_F(CubeDamage, ATruncatedFileIsRefusedWhereverItEnds) {
  const std::string valid = validFile();
  ASSERT_EQ(readBoth(valid), 0);
  for (std::size_t length = 0; length < valid.size(); length += 64) {
    EXPECT_GE(readBoth(valid.substr(0, length)), 1) << length;  // the environment part may still be whole
  }
}

TEST_F(CubeDamage, AFlippedByteIsAnotherValueOrARefusal) {
  const std::string valid = validFile();
  int refused = 0;
  unsigned state = 7;
  for (int i = 0; i < 400; ++i) {
    state = state * 1664525u + 1013904223u;
    // Half of them in the headers, where sizes and types are.
    const std::size_t range = i % 2 == 0 ? std::min<std::size_t>(6000, valid.size()) : valid.size();
    std::string damaged = valid;
    char& byte = damaged[(state >> 8) % range];
    byte = static_cast<char>(i % 3 == 0 ? 0xff : byte ^ (1 << (i % 8)));
    refused += readBoth(damaged) > 0 ? 1 : 0;
  }
  EXPECT_GT(refused, 50);
}

/// A header that promises width x height, and zeros after it: enough for the table of where its lines are.
std::string promise(int width, int height, const std::string& path) {
  Imf::Header header(16, 16);
  header.channels().insert("R", Imf::Channel(Imf::HALF));
  header.channels().insert("G", Imf::Channel(Imf::HALF));
  header.channels().insert("B", Imf::Channel(Imf::HALF));
  std::vector<half> values(256);
  {
    Imf::FrameBuffer buffer;
    for (const char* name : {"R", "G", "B"}) {
      buffer.insert(name, Imf::Slice::Make(Imf::HALF, values.data(), header.dataWindow()));
    }
    Imf::OutputFile out(path.c_str(), header);
    out.setFrameBuffer(buffer);
    out.writePixels(16);
  }
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  std::string bytes = text.str();
  for (const std::string window : {"dataWindow", "displayWindow"}) {
    // name 0, "box2i" 0, size 4 bytes, then xMin yMin xMax yMax, little-endian.
    const std::size_t at = bytes.find(window + std::string("\0box2i\0", 7)) + window.size() + 7 + 4 + 8;
    const int max[2] = {width - 1, height - 1};
    for (std::size_t i = 0; i < 8; ++i) {
      bytes[at + i] = static_cast<char>(static_cast<unsigned>(max[i / 4]) >> (8 * (i % 4)));
    }
  }
  return bytes + std::string(1 << 20, '\0');
}

/// Runs `work` in a process of its own that may ask for `bytes` more memory and write files of `fileBytes`; its exit
/// status is the number of failed expectations, or 99 if a signal or an exception ended it.
template <typename Work>
int inLimits(rlim_t bytes, rlim_t fileBytes, Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit file = {fileBytes, fileBytes};
    ::setrlimit(RLIMIT_FSIZE, &file);
#if !defined(__SANITIZE_ADDRESS__)  // which reserves the whole address space at its start
    const rlimit memory = {bytes, bytes};
    ::setrlimit(RLIMIT_AS, &memory);
#else
    static_cast<void>(bytes);
#endif
    int status = 99;
    try {
      status = work();
    } catch (const std::exception& error) {
      std::cerr << error.what() << std::endl;
    }
    ::_exit(status);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 99;
}

TEST_F(CubeDamage, SizesAreRefusedBeforeMemoryIsAsked) {
  const std::string path = file("huge.exr");
  struct Case {
    int width, height;
    std::string said;
  };
  const Case cases[] = {{100000, 100000, "is 100000 x 100000 pixels; at most 32768 a side are read"},
                        {32768, 16384, "is 32768 x 16384 pixels; at most 134217728 in all are read"},
                        {16384, 8192, "part 0 is not complete; save it again"},
                        {2000000000, 1000000000, "at most 32768 a side are read"}};
  for (const Case& promised : cases) {
    write("huge.exr", promise(promised.width, promised.height, path));
    constexpr rlim_t kMemory = rlim_t(1) << 30;  // a quarter of what the third one would take
    const int status = inLimits(kMemory, RLIM_INFINITY, [&] {
      try {
        loadCube(path);
      } catch (const InputError& error) {
        const std::string text = error.what();
        std::cerr << text << std::endl;
        return text.rfind(path, 0) == 0 && text.find(promised.said) != std::string::npos ? 0 : 1;
      }
      return 2;
    });
    EXPECT_EQ(status, 0) << promised.width << " x " << promised.height;
  }
}

// Few pixels in a frame of a panorama's shape, which would be filled: the frame has a size, too.
TEST_F(CubeDamage, AFrameAroundFewPixelsHasALimit) {
  const std::string path = file("framed.exr");
  const Imath::Box2i pixels({11, 7}, {27, 15});
  Imf::Header header(Imath::Box2i({0, 0}, {65999, 32999}), pixels);
  std::vector<half> values(17 * 9, half(0.5f));
  Imf::FrameBuffer buffer;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::HALF));
    buffer.insert(name, Imf::Slice::Make(Imf::HALF, values.data(), pixels));
  }
  {
    Imf::OutputFile out(path.c_str(), header);
    out.setFrameBuffer(buffer);
    out.writePixels(9);
  }
  constexpr rlim_t kMemory = rlim_t(1) << 30;
  EXPECT_EQ(inLimits(kMemory, RLIM_INFINITY,
                     [&] {
                       try {
                         loadCube(path);
                       } catch (const InputError& error) {
                         const std::string text = error.what();
                         std::cerr << text << std::endl;
                         return text == path + ": is 66000 x 33000 pixels; at most 32768 a side are read" ? 0 : 1;
                       }
                       return 2;
                     }),
            0);
}

TEST_F(CubeDamage, ADiskThatIsFullLeavesTheOldFileAndNoOther) {
  write("probe.exr", "the old one");
  const int status = inLimits(RLIM_INFINITY, 20000, [&] {
    BakedProbeFile probe;
    probe.maps.radiance = noisyHalfCube(64, 7);
    int failures = 0;
    try {
      saveBakedProbe(file("probe.exr"), probe);
      ++failures;
    } catch (const WorkError& error) {
      if (std::string(error.what()).rfind(file("probe.exr") + ": cannot be written: ", 0) != 0) ++failures;
    }
    try {
      saveCubePicture(file("map.exr"), probe.maps.radiance, CubeLayout::LatLong);
      ++failures;
    } catch (const WorkError&) {
    }
    return failures;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read("probe.exr"), "the old one");
  EXPECT_EQ(entryCount(), 1u);
}

TEST_F(CubeDamage, AFolderThatIsNotThereOrADeviceIsNamed) {
  BakedProbeFile probe;
  probe.maps.radiance = noisyHalfCube(16, 5);
  EXPECT_EQ(errorText<WorkError>([&] { saveBakedProbe(file("gone/a.exr"), probe); }).rfind(file("gone/a.exr"), 0), 0u);
  EXPECT_EQ(errorText<WorkError>([&] { saveBakedProbe(folder_.string(), probe); }).rfind(folder_.string(), 0), 0u);
  EXPECT_EQ(entryCount(), 0u);
}

TEST_F(CubeDamage, DeepDataIsRefusedByName) {
  Imf::Header header(8, 4);
  header.channels().insert("R", Imf::Channel(Imf::HALF));
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  {
    std::vector<unsigned> counts(32, 0u);
    std::vector<half*> samples(32, nullptr);
    Imf::DeepFrameBuffer buffer;
    buffer.insertSampleCountSlice(Imf::Slice::Make(Imf::UINT, counts.data(), header.dataWindow()));
    buffer.insert("R", Imf::DeepSlice(Imf::HALF, reinterpret_cast<char*>(samples.data()), sizeof(half*),
                                      8 * sizeof(half*), sizeof(half)));
    Imf::DeepScanLineOutputFile out(file("deep.exr").c_str(), header);
    out.setFrameBuffer(buffer);
    out.writePixels(4);
  }
  EXPECT_EQ(errorText([&] { loadCube(file("deep.exr")); }),
            file("deep.exr") + ": part 0 is deep data (deepscanline); flatten it first");
}

TEST_F(CubeDamage, NonFiniteValuesInABakedFileAreZero) {
  BakedProbeFile probe;
  probe.maps.radiance = noisyHalfCube(16, 5);
  probe.maps.radiance.setTexel(1, 2, 3, 4, glm::vec4(std::numeric_limits<float>::quiet_NaN(), 1, 1, 1));
  saveBakedProbe(file("a.exr"), probe, ExrPrecision::Float);
  EXPECT_EQ(loadBakedProbe(file("a.exr")).maps.radiance.texel(1, 2, 3, 4), glm::vec4(0, 1, 1, 1));
}

}  // namespace
}  // namespace boxprobe
