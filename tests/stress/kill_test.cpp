// kill -9 while scenes and baked probes are saved, at random moments and, every other time, while a temporary file is
// there: the old or the new file is there, whole, and what a killed process left behind is gone after the next save.
// Forty times each; BOXPROBE_KILLS=100 kill_test: a hundred.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <random>

#include "filters/io/cube/bake_folder.h"
#include "filters/io/scene/scene_file.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

// Of each kind.
const int kKills = [] {
  const char* wanted = std::getenv("BOXPROBE_KILLS");
  return wanted != nullptr ? std::max(std::atoi(wanted), 1) : 40;
}();

/// Of a save no small part is its temporary file: far fewer are needed.
constexpr int kMostStops = 100000;

class Kill : public TemporaryFolder {
 protected:
  /// Starts the saver, lets it save once, and kills it: at a random moment of the next two saves or so, or, where
  /// `aimed` names a folder, while a temporary file is in it. Random moments alone seldom hit a save where a process
  /// takes long to start and a save is short. That the file is there is seen while the saver stands still.
  void saveAndKill(const char* kind, const std::string& target, const std::filesystem::path& aimed) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::execl(BOXPROBE_SAVER, BOXPROBE_SAVER, kind, target.c_str(), nullptr);
      ::_exit(127);
    }
    ::close(ends[1]);
    const auto start = std::chrono::steady_clock::now();
    char line[8];
    const auto said = ::read(ends[0], line, sizeof(line));
    const std::chrono::duration<double, std::micro> oneSave = std::chrono::steady_clock::now() - start;
    if (aimed.empty()) {
      ::usleep(static_cast<useconds_t>(oneSave.count() * 2.0 * (random_() % 1000) / 1000.0));
    } else {
      bool hit = false;
      for (int i = 0; i < kMostStops && !hit; ++i) {
        ::usleep(static_cast<useconds_t>(random_() % 1000));
        ::kill(child, SIGSTOP);
        siginfo_t stopped = {};
        ::waitid(P_PID, static_cast<id_t>(child), &stopped, WSTOPPED | WEXITED | WNOWAIT);
        hit = stopped.si_code != CLD_STOPPED || holdsTemporary(aimed);
        if (!hit) ::kill(child, SIGCONT);
      }
      EXPECT_TRUE(hit) << "never stopped within a save";
    }
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(ends[0]);
    ASSERT_GT(said, 0) << "the saver ended by itself";
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  /// The three probes as version 0 of the saver would have them.
  static void saveZero(const std::filesystem::path& folder) {
    BakedMaps maps;
    maps.radiance = CubeMap(8, 3);
    for (int i = 0; i < 3; ++i) {
      Probe probe;
      probe.name = "probe " + std::to_string(i);
      BakeFolder::save(folder.string(), probe, {"v0", "v0", {}, {}}, maps, {"test", {}});
    }
  }

  /// Whether a temporary file stands in the folder: of a living process, as the first save took away the others.
  static bool holdsTemporary(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::directory_iterator entry(folder, ignored);
    for (; !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
      if (entry->path().filename().native().front() == '.') return true;
    }
    return false;
  }

  /// Folders of saves that were cut off; everything else has `extension`.
  std::size_t leftovers(const std::filesystem::path& folder, const std::string& extension) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      const bool left = name.front() == '.';
      EXPECT_TRUE(left || entry.path().extension() == extension) << name;
      count += left ? 1 : 0;
    }
    return count;
  }

  std::minstd_rand random_{1};
};

TEST_F(Kill, AScene) {
  const std::string path = file("scene.boxprobe.json");
  int cutOff = 0;
  double last = 0.0;
  for (int i = 0; i < kKills; ++i) {
    saveAndKill("scene", path, i % 2 == 0 ? std::filesystem::path() : folder_);
    ASSERT_FALSE(HasFatalFailure());
    const Scene scene = loadSceneFile(path);
    ASSERT_EQ(scene.probes.size(), std::fmod(scene.exposure, 2.0) == 0.0 ? 40u : 80u);
    ASSERT_EQ(scene.probes.back().intensity, scene.exposure) << "half of one version, half of another";
    last = std::max(last, scene.exposure);
    const std::size_t left = leftovers(folder_, ".json");
    ASSERT_LE(left, 1u) << "they pile up";
    cutOff += static_cast<int>(left);
  }
  std::cout << kKills << " kills, " << cutOff << " in the middle of a save, up to " << last << " saves before one\n";
  EXPECT_GE(cutOff, kKills / 2) << "the kills hit nothing";
  saveSceneFile(Scene(), path);
  EXPECT_EQ(entryCount(), 1u);
}

TEST_F(Kill, ABakeFolder) {
  const std::filesystem::path folder = folder_ / "scene.probes";
  saveZero(folder);
  int cutOff = 0;
  for (int i = 0; i < kKills; ++i) {
    saveAndKill("bake", folder.string(), i % 2 == 0 ? std::filesystem::path() : folder);
    ASSERT_FALSE(HasFatalFailure());
    for (const char* name : {"probe 0.exr", "probe 1.exr", "probe 2.exr"}) {
      const BakedProbeFile baked = loadBakedProbe((folder / name).string());
      const float value = baked.maps.radiance.texel(0, 0, 0, 0).x;
      ASSERT_EQ(BakeRecord::parse(baked.info.inputHash)->key, "v" + std::to_string(static_cast<int>(value)));
      const CubeMap& maps = baked.maps.radiance;
      ASSERT_EQ(maps.texel(maps.levels() - 1, 5, 0, 0).x, value);
      ASSERT_EQ(maps.texel(0, 5, 7, 7).w, value);
    }
    const std::size_t left = leftovers(folder, ".exr");
    ASSERT_LE(left, 3u) << "they pile up";
    cutOff += left > 0 ? 1 : 0;
  }
  std::cout << kKills << " kills, " << cutOff << " with a save cut off\n";
  EXPECT_GE(cutOff, kKills / 2) << "the kills hit nothing";
  saveZero(folder);
  EXPECT_EQ(leftovers(folder, ".exr"), 0u);
}

}  // namespace
}  // namespace boxprobe
