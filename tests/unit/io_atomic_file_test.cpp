// Whole or not at all: what is left when a write succeeds, fails, or has nowhere to go.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
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
    struct stat status = {};
    ASSERT_EQ(::stat(std::filesystem::path(name).parent_path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0700u) << "nobody else reads what may be private";
    std::ofstream(name) << "new";
  });
  EXPECT_EQ(read("a.txt"), "new");
  EXPECT_EQ(std::filesystem::path(temporary).parent_path().parent_path(), folder_);
  EXPECT_EQ(std::filesystem::path(temporary).filename(), "a.txt") << "writers look at extensions";
  EXPECT_EQ(entryCount(), 1u);
  struct stat status = {};
  ASSERT_EQ(::stat(file("a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(AtomicFile, FilesOfTheUsersStayWhateverTheirNames) {
  for (const char* name : {".o.2024-11.png", ".o.7-1.png", ".boxprobe-unfinished-file"}) write(name, "mine");
  const auto makeFolder = [&](const char* name) { std::filesystem::create_directory(folder_ / name); };
  makeFolder(".boxprobe-unfinished-unclaimed");
  write(".boxprobe-unfinished-unclaimed/o.png", "mine");
  makeFolder(".boxprobe-unfinished-other");
  write(".boxprobe-unfinished-other/claim", "what I claim");
  write(".boxprobe-unfinished-other/o.png", "mine");
  // One that leads elsewhere.
  write("kept.png", "mine");
  makeFolder(".boxprobe-unfinished-sly");
  std::filesystem::create_symlink("boxprobe-unfinished:../kept.png", folder_ / ".boxprobe-unfinished-sly/claim");
  writeTextAtomically(file("o.png"), "new");
  for (const char* name : {".o.2024-11.png", ".o.7-1.png", ".boxprobe-unfinished-file",
                           ".boxprobe-unfinished-unclaimed/o.png", ".boxprobe-unfinished-other/o.png", "kept.png"}) {
    EXPECT_EQ(read(name), "mine") << name;
  }
}

TEST_F(AtomicFile, WhatAKilledProcessLeftGoesWithTheNextWrite) {
  for (const char* name : {".boxprobe-unfinished-link", ".boxprobe-unfinished-file", ".boxprobe-unfinished-empty"}) {
    std::filesystem::create_directory(folder_ / name);
  }
  write(".boxprobe-unfinished-link/b.exr", "half");
  std::filesystem::create_symlink("boxprobe-unfinished:b.exr", folder_ / ".boxprobe-unfinished-link/claim");
  write(".boxprobe-unfinished-file/b.exr", "half");
  write(".boxprobe-unfinished-file/claim", "boxprobe-unfinished:b.exr");  // where there are no links
  write(".boxprobe-unfinished-file/mine.txt", "mine");
  writeTextAtomically(file("o.png"), "new");
  EXPECT_FALSE(std::filesystem::exists(folder_ / ".boxprobe-unfinished-link"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / ".boxprobe-unfinished-empty"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / ".boxprobe-unfinished-file/b.exr"));
  EXPECT_EQ(read(".boxprobe-unfinished-file/mine.txt"), "mine") << "no claim names it";
}

TEST_F(AtomicFile, AWriteUnderWayIsLeftAlone) {
  writeAtomically(file("a.txt"), [&](const std::string& name) {
    std::ofstream(name) << "a";
    writeTextAtomically(file("b.txt"), "b");
    EXPECT_TRUE(std::filesystem::exists(name));
  });
  EXPECT_EQ(read("a.txt") + read("b.txt"), "ab");
  EXPECT_EQ(entryCount(), 2u);
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
  // A file in the place of /dev/null would be the end of it.
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", file("to the pipe"));
  for (const char* name : {"pipe", "to the pipe"}) {
    EXPECT_EQ(errorText<WorkError>([&] { writeTextAtomically(file(name), "x"); }),
              file(name) + ": is a pipe or device, not a file; name a file");
  }
  EXPECT_TRUE(std::filesystem::is_fifo(file("pipe")));
  std::filesystem::create_symlink("b", file("a"));
  std::filesystem::create_symlink("a", file("b"));
  EXPECT_EQ(errorText<WorkError>([&] { writeTextAtomically(file("a"), "x"); }),
            file("a") + ": its links lead round in a circle; name another file");
  EXPECT_TRUE(std::filesystem::is_symlink(file("a")));
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
