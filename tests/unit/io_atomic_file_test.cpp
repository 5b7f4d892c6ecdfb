// Whole or not at all: what is left when a write succeeds, fails, or has nowhere to go.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <stdexcept>

#include "filters/io/files/atomic_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class AtomicFile : public TemporaryFolder {};

TEST_F(AtomicFile, ReplacesTheOldFileAndKeepsItsPermissions) {
  write("a.txt", "old");
  ::chmod(file("a.txt").c_str(), 0640);
  std::string temporary;
  writeAtomically(file("a.txt"), [&](const std::string& name) {
    temporary = name;
    EXPECT_EQ(read("a.txt"), "old");  // until the very end
    std::ofstream(name) << "new";
  });
  EXPECT_EQ(read("a.txt"), "new");
  EXPECT_EQ(std::filesystem::path(temporary).parent_path(), folder_);
  EXPECT_EQ(std::filesystem::path(temporary).extension(), ".txt");
  EXPECT_EQ(entryCount(), 1u);
  struct stat status = {};
  ASSERT_EQ(::stat(file("a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(AtomicFile, AWriterThatThrowsLeavesTheOldFileAlone) {
  write("a.txt", "old");
  EXPECT_THROW(writeAtomically(file("a.txt"),
                               [](const std::string& name) {
                                 std::ofstream(name) << "half";
                                 throw std::runtime_error("stopped");
                               }),
               std::runtime_error);
  EXPECT_EQ(read("a.txt"), "old");
  EXPECT_EQ(entryCount(), 1u);
}

TEST_F(AtomicFile, AWriterThatRemovesItsFileIsAFailure) {
  EXPECT_THROW(writeAtomically(file("a.txt"), [](const std::string& name) { std::filesystem::remove(name); }),
               WorkError);
  EXPECT_EQ(entryCount(), 0u);
}

TEST_F(AtomicFile, PlacesThatCannotBeWrittenAreNamed) {
  EXPECT_EQ(errorText<WorkError>([&] { writeTextAtomically(file("gone/a.txt"), "x"); }),
            file("gone/a.txt") + ": the folder " + file("gone") + " does not exist; make it first");
  EXPECT_EQ(errorText<WorkError>([&] { writeTextAtomically(folder_.string(), "x"); }),
            folder_.string() + ": is a folder; name a file in it");
  EXPECT_EQ(errorText<WorkError>([&] {
              writeTextAtomically("/proc/boxprobe.txt", "x");
            }).rfind("/proc/boxprobe.txt: cannot write in its folder: ", 0),
            0u);
}

TEST_F(AtomicFile, ALinkStaysALink) {
  write("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder_ / "link.txt");
  writeTextAtomically(file("link.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(read("real.txt"), "new");
}

TEST_F(AtomicFile, TextIsWrittenByteForByte) {
  const std::string bytes("a\r\n\0b\xff", 6);
  writeTextAtomically(file("a.bin"), bytes);
  EXPECT_EQ(read("a.bin"), bytes);
}

}  // namespace
}  // namespace boxprobe
