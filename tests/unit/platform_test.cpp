// What the platform room promises on every system, held against the standard library and against what is known by
// construction.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "filters/platform/folders.h"
#include "filters/platform/input_file.h"
#include "filters/platform/name_pattern.h"
#include "filters/platform/output_file.h"
#include "filters/platform/process.h"

namespace boxprobe {
namespace {

namespace fs = std::filesystem;

class Platform : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto made = makeFolder((fs::temp_directory_path() / "boxprobe-platform-").string());
    ASSERT_TRUE(made);
    folder_ = *made;
  }
  void TearDown() override { fs::remove_all(fs::u8path(folder_)); }

  std::string at(const std::string& name) const { return folder_ + "/" + name; }
  static void writeFile(const std::string& path, const std::string& text) {
    std::ofstream(fs::u8path(path), std::ios::binary) << text;
  }
  static std::string textOf(const std::string& path) {
    std::ifstream stream(fs::u8path(path), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string folder_;
};

TEST_F(Platform, PatternsMatchAsInAShell) {
  const struct {
    const char *pattern, *name;
    bool matches;
  } rows[] = {{"hall", "hall", true},
              {"hall", "hall2", false},
              {"h*l", "hall", true},
              {"h*l", "halt", false},
              {"*", "", true},
              {"h?ll", "hall", true},
              {"h?ll", "hll", false},
              {"room[1-3]", "room2", true},
              {"room[1-3]", "room4", false},
              {"room[!1-3]", "room4", true},
              {"room[!1-3]", "room3", false},
              {"a\\*b", "a*b", true},
              {"a\\*b", "axb", false},
              {"*a*b*a", "xaybza", true},
              {"*a*b*a", "xaybz", false},
              {"[]x]", "]", true},
              {"[a", "[a", true},
              {"**b", "aab", true},
              {"", "", true},
              {"", "a", false},
              {"[a-]", "-", true}};
  for (const auto& row : rows) {
    EXPECT_EQ(matchesPattern(row.pattern, row.name), row.matches) << row.pattern << " and " << row.name;
  }
}

TEST_F(Platform, ProcessTimeIsTheClocks) {
  const double before = processCpuSeconds();
  const std::clock_t clockBefore = std::clock();
  volatile double sum = 0.0;
  while (static_cast<double>(std::clock() - clockBefore) < 0.1 * CLOCKS_PER_SEC) sum = sum + 1.0;
  const double spent = processCpuSeconds() - before;
  const double bySystem = static_cast<double>(std::clock() - clockBefore) / CLOCKS_PER_SEC;
#ifdef _WIN32
  EXPECT_GT(bySystem, spent * 0.5);  // its clock() counts the wall's time
#else
  EXPECT_NEAR(spent, bySystem, 0.02);
#endif
  EXPECT_GT(spent, 0.0);
}

TEST_F(Platform, ThePeakGrowsByWhatIsWritten) {
  static std::size_t bytes = 0;                            // a peak never falls: run once more, there is more to write
  constexpr std::size_t kBytes = std::size_t{256} << 20u;  // much beside what the system takes back meanwhile
  bytes += kBytes;
  const std::uint64_t before = peakResidentBytes();
  std::vector<char> pages(bytes, 'x');
  const std::uint64_t grown = peakResidentBytes() - before;
  EXPECT_EQ(pages[kBytes / 3], 'x');
  EXPECT_GT(grown, kBytes / 10 * 9);
#ifndef __SANITIZE_THREAD__  // which keeps a shadow of what is written
  EXPECT_LT(grown, kBytes * 2);
#endif
  EXPECT_GT(physicalMemoryBytes(), peakResidentBytes());
}

TEST_F(Platform, TheProgramIsTheFileThatRuns) {
  const fs::path program = fs::u8path(programPath());
  EXPECT_TRUE(fs::is_regular_file(program)) << program;
  EXPECT_EQ(program.stem().string(), "platform_test");
  EXPECT_GT(processNumber(), 0);
  EXPECT_TRUE(processLives(processNumber()));
  EXPECT_FALSE(processLives(0x3ffffff1));  // more than Linux counts to
  EXPECT_FALSE(userText().empty());
}

TEST_F(Platform, TheEnvironmentIsSetAndKept) {
  setEnvironment("BOXPROBE_PLATFORM_TEST", "one", false);
  EXPECT_STREQ(std::getenv("BOXPROBE_PLATFORM_TEST"), "one");
  setEnvironment("BOXPROBE_PLATFORM_TEST", "two", false);
  EXPECT_STREQ(std::getenv("BOXPROBE_PLATFORM_TEST"), "one");
  setEnvironment("BOXPROBE_PLATFORM_TEST", "three", true);
  EXPECT_STREQ(std::getenv("BOXPROBE_PLATFORM_TEST"), "three");
}

TEST_F(Platform, AFileIsWhatItIs) {
  const std::string file = at("z\xc3\xbcrich \xe2\x88\x9e.bin");
  writeFile(file, "four\n\r\n");
  const auto status = fileStatus(file);
  ASSERT_TRUE(status);
  EXPECT_EQ(status->kind, FileStatus::Kind::File);
  EXPECT_EQ(status->size, 7u);
  writeFile(at("other"), "");
  EXPECT_FALSE(fileStatus(at("other"))->identity == status->identity);
  EXPECT_TRUE(fileStatus(folder_ + "/./z\xc3\xbcrich \xe2\x88\x9e.bin")->identity == status->identity);
  EXPECT_EQ(fileStatus(folder_)->kind, FileStatus::Kind::Folder);
  errno = 0;
  EXPECT_FALSE(fileStatus(at("missing")));
  EXPECT_EQ(errno, ENOENT);

  InputFile input(file);
  ASSERT_TRUE(input.isOpen());
  EXPECT_TRUE(input.status()->identity == status->identity);
  char bytes[16] = {};
  EXPECT_EQ(input.read(bytes, sizeof bytes), 7);
  EXPECT_EQ(std::string(bytes, 7), "four\n\r\n");
  EXPECT_EQ(input.read(bytes, sizeof bytes), 0);
  EXPECT_FALSE(InputFile(at("missing")).isOpen());
}

TEST_F(Platform, ANewFileIsNewAndReplacesAnother) {
  const std::string path = at("new");
  {
    NewFile file(path, Access::UserAlone);
    ASSERT_TRUE(file.isOpen());
    EXPECT_TRUE(file.write("a\nb", 3));
  }
  EXPECT_EQ(textOf(path), "a\nb");
  errno = 0;
  EXPECT_FALSE(NewFile(path, Access::AsUsual).isOpen());
  EXPECT_EQ(errno, EEXIST);
  EXPECT_EQ(flushFile(path), Flushed::Done);
  EXPECT_EQ(flushFile(at("missing")), Flushed::NotOpened);
  EXPECT_EQ(flushFolder(folder_), Flushed::Done);

  writeFile(at("old"), "before");
  EXPECT_TRUE(replaceFile(path, at("old")));
  EXPECT_EQ(textOf(at("old")), "a\nb");
  EXPECT_FALSE(fileStatus(path));
  errno = 0;
  EXPECT_FALSE(replaceFile(path, at("old")));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(textOf(at("old")), "a\nb");
  EXPECT_TRUE(removeFile(at("old").c_str()));
  EXPECT_FALSE(removeFile(at("old").c_str()));
}

// A temporary file is renamed while it is written, and one that is read is removed by somebody else.
TEST_F(Platform, AnOpenFileIsRenamedAndRemoved) {
  const std::string path = at("open");
  NewFile file(path, Access::AsUsual);
  EXPECT_TRUE(file.write("one", 3));
  EXPECT_TRUE(replaceFile(path, at("moved"))) << errno;
  EXPECT_TRUE(file.write("two", 3));
  EXPECT_EQ(textOf(at("moved")), "onetwo");
  InputFile input(at("moved"));
  EXPECT_TRUE(removeFile(at("moved").c_str())) << errno;
  char bytes[8] = {};
  EXPECT_EQ(input.read(bytes, sizeof bytes), 6);
}

// By the program's manifest on Windows. Elsewhere the C library passes bytes on, and this cannot fail.
TEST_F(Platform, TextOfTheCLibraryIsUtf8) {
  const std::string path = at("z\xc3\xbcrich");
  writeFile(path, "here");
  std::FILE* file = std::fopen(path.c_str(), "rb");
  ASSERT_NE(file, nullptr);
  std::fclose(file);
}

TEST_F(Platform, ANameIsStoredOnce) {
  EXPECT_TRUE(storeName(at("claim"), "room.json"));
  EXPECT_FALSE(storeName(at("claim"), "other.json"));
  EXPECT_EQ(storedName(at("claim")), "room.json");
  EXPECT_EQ(storedName(at("missing")), "");
  EXPECT_TRUE(removeFile(at("claim").c_str()));
}

TEST_F(Platform, AFolderIsLockedByOne) {
  const auto first = makeFolder(at("x-")), second = makeFolder(at("x-"));
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
  EXPECT_EQ(first->size(), at("x-").size() + 6);
  EXPECT_TRUE(canWriteInto(*first));
  EXPECT_TRUE(isUsersOwn(*first));
  EXPECT_FALSE(isUsersOwn(at("missing")));
  writeFile(at("file"), "");
  EXPECT_FALSE(FolderLock(at("file")).isOpen());
  {
    FolderLock mine(*first), others(*first);
    ASSERT_TRUE(mine.isOpen() && others.isOpen());
    EXPECT_TRUE(mine.lock());
    EXPECT_FALSE(others.lock());
    writeFile(*first + "/inside", "");  // the lock is on the folder
    mine.remove();
  }
  EXPECT_TRUE(fileStatus(*first)) << "a folder with a file in it is not removed";
  EXPECT_FALSE(removeEmptyFolder(first->c_str()));
  EXPECT_TRUE(removeFile((*first + "/inside").c_str()));
  {
    FolderLock again(*first);
    EXPECT_TRUE(again.lock());
    again.remove();
  }
  EXPECT_FALSE(fileStatus(*first));
  EXPECT_TRUE(removeEmptyFolder(second->c_str()));
  EXPECT_FALSE(makeFolder(at("missing/x-")));
}

}  // namespace
}  // namespace boxprobe
