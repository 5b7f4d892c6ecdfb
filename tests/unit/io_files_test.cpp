// What may be opened, what may be written over, and what must not be left: files, links, pipes, devices.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "filters/core/base/printable_text.h"
#include "filters/core/base/read_number.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/inside_folder.h"
#include "filters/io/files/read_file.h"
#include "filters/io/files/temporary_file.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/json/json_text.h"
#include "filters/io/obj/obj_file.h"
#include "filters/io/scene/pareto_front_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

class Files : public TemporaryFolder {};

// Whoever follows a model has to look at all of these.
TEST_F(Files, WhatAModelAsksForIsCollected) {
  write("a.mtl", "newmtl p\nmap_Kd here.png\nmap_Pr gone.png\n");
  write("here.png", "no picture");
  const std::string obj = write("a.obj", "mtllib a.mtl other.mtl\nusemtl p\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string gltf =
      write("b.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "b.bin", "byteLength": 4}]})");
  write("b.bin", "1234");
  const FileStamp picture = stampOf(file("here.png"));
  std::map<std::string, FileStamp> stamps;
  {
    const FilesAsked asked;
    readObj(obj);
    loadModelFile(gltf);
    write("here.png", "no picture, and written while the model was read");
    readObj(obj);
    stamps = asked.stamps();
  }
  for (const char* name : {"a.obj", "a.mtl", "other.mtl", "here.png", "gone.png", "b.gltf", "b.bin"}) {
    EXPECT_EQ(stamps.count(file(name)), 1u) << name;
  }
  EXPECT_TRUE(stamps[file("here.png")] == picture) << "as it was first";
  EXPECT_FALSE(stampOf(file("here.png")) == picture);
  EXPECT_TRUE(stamps[file("gone.png")] == FileStamp());
  loadModelFile(gltf);  // nobody collects any more
}

// A pipe without a writer would hold its reader for ever.
TEST_F(Files, PipesAndDevicesAreNotOpened) {
  for (const char* name :
       {"p.exr", "p.hdr", "p.png", "p.glb", "p.gltf", "p.obj", "p.ply", "p.stl", "p.vtp", "p.json"}) {
    ASSERT_EQ(::mkfifo(file(name).c_str(), 0600), 0);
  }
  const auto expectRefused = [&](auto read, const std::string& path) {
    const std::string text = errorText([&] { read(path); });
    EXPECT_NE(text.find("is not a file but a pipe or device"), std::string::npos) << text;
  };
  expectRefused([](const std::string& path) { loadHdrImage(path); }, file("p.exr"));
  expectRefused([](const std::string& path) { loadHdrImage(path); }, file("p.hdr"));
  expectRefused([](const std::string& path) { loadImage8(path); }, file("p.png"));
  expectRefused([](const std::string& path) { loadCube(path); }, file("p.exr"));
  expectRefused([](const std::string& path) { loadBakedProbe(path); }, file("p.exr"));
  expectRefused([](const std::string& path) { loadModelFile(path); }, file("p.glb"));
  expectRefused([](const std::string& path) { readObj(path); }, file("p.obj"));
  expectRefused([](const std::string& path) { loadSceneFile(path); }, file("p.json"));
  expectRefused([](const std::string& path) { loadParetoFront(path, "box"); }, file("p.json"));
  expectRefused([](const std::string& path) { readWholeFile(path); }, "/dev/zero");
  EXPECT_FALSE(bakedProbeMark(file("p.exr")));
  EXPECT_EQ(errorText([&] { readWholeFile(folder_.string()); }), folder_.string() + ": is a folder; name a file");
}

TEST_F(Files, AnOutputIsNoInputUnderAnyName) {
  const std::string input = write("in.txt", "text");
  std::filesystem::create_symlink(input, file("soft.txt"));
  std::filesystem::create_hard_link(input, file("hard.txt"));
  EXPECT_EQ(readWholeFile(input), "text");
  declareOutput("-o", file("soft.txt"));
  declareOutput("-o", file("not there.txt"));
  for (const char* name : {"in.txt", "soft.txt", "hard.txt"}) {
    EXPECT_EQ(errorText([&] { readWholeFile(file(name)); }),
              "-o " + file("soft.txt") + ": this is the input " + file(name) + "; write to another file");
  }
  EXPECT_EQ(readWholeFile(write("other.txt", "other")), "other");
  // Once the output is another file, what it was may be read.
  declareOutput("-o", write("out.txt", "before"));
  std::filesystem::create_hard_link(file("out.txt"), file("kept.txt"));
  EXPECT_NE(errorText([&] { readWholeFile(file("kept.txt")); }), "");
  std::filesystem::rename(write("made.txt", "made"), file("out.txt"));
  EXPECT_EQ(readWholeFile(file("kept.txt")), "before");
}

TEST_F(Files, LinksStayLinksAlsoDanglingOnesInChains) {
  std::filesystem::create_directories(folder_ / "sub");
  std::filesystem::create_symlink("sub/second.txt", file("first.txt"));
  std::filesystem::create_symlink("third.txt", file("sub/second.txt"));
  for (const char* text : {"new", "newer"}) {
    writeTextAtomically(file("first.txt"), text);
    EXPECT_TRUE(std::filesystem::is_symlink(file("first.txt")));
    EXPECT_TRUE(std::filesystem::is_symlink(file("sub/second.txt")));
    EXPECT_FALSE(std::filesystem::is_symlink(file("sub/third.txt")));
    EXPECT_EQ(read("sub/third.txt"), text);
  }
  std::filesystem::create_symlink("b.txt", file("a.txt"));
  std::filesystem::create_symlink("a.txt", file("b.txt"));
  EXPECT_NO_THROW(writtenPath(file("a.txt")));
}

TEST_F(Files, TemporaryFilesGoAtTheEndAndOnASignal) {
  std::string name;
  {
    TemporaryFile temporary(folder_.string(), ".t-");
    temporary.write("text");
    name = temporary.name();
    EXPECT_EQ(std::filesystem::file_size(name), 4u);
  }
  EXPECT_FALSE(std::filesystem::exists(name));
  TemporaryFile first(folder_.string(), ".t-"), second(folder_.string(), ".t-");
  write("kept.txt", "");
  TemporaryName kept(file("kept.txt"));
  kept.release();
  removeTemporaryFiles();
  EXPECT_EQ(entryCount(), 1u);
  const std::string text = errorText<WorkError>([&] { TemporaryFile(file("gone"), ".t-"); });
  EXPECT_EQ(text, "cannot write into " + file("gone") + ": No such file or directory");
}

TEST_F(Files, InsideAFolderNeedsNoFileAndNoAbsolutePath) {
  EXPECT_TRUE(insideFolderOf("nope.mtl", "m.obj"));
  EXPECT_TRUE(insideFolderOf("sub/nope.mtl", "m.obj"));
  EXPECT_FALSE(insideFolderOf("../nope.mtl", "m.obj"));
  EXPECT_FALSE(insideFolderOf("/etc/passwd", "m.obj"));
  std::filesystem::create_symlink("/etc", file("link"));
  EXPECT_FALSE(insideFolderOf(file("link/passwd"), file("m.obj")));
}

TEST(PrintableText, TerminalsShowItAndDoNotObeyIt) {
  EXPECT_EQ(printable("a\x1b[31m\a\nb"), "a [31m  b");
  EXPECT_EQ(printable("a\nb\r", true), "a\nb ");
  EXPECT_EQ(printable("\xc2\x9b[2J"), " [2J") << "the C1 control CSI";
  EXPECT_EQ(printable("\x9b"), "\xef\xbf\xbd") << "the same as one byte";
  EXPECT_EQ(printable("caf\xe9"), "caf\xef\xbf\xbd");
  EXPECT_EQ(printable("Größe 木 \xf0\x9f\xaa\x9e"), "Größe 木 \xf0\x9f\xaa\x9e");
  EXPECT_EQ(printable("\xd7\x97\xd7\x93\xd7\xa8"), "\xd7\x97\xd7\x93\xd7\xa8") << "Hebrew letters";
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b"),
            "a b")
      << "right-to-left override";
  EXPECT_EQ(printable("\xc0\xaf\xed\xa0\x80\xf8"),
            "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(JsonLimits, WhatHasMoreEntriesIsNamedBeforeItIsRead) {
  const auto withCameras = [](int count) {
    std::string text = "{\"cameras\": {";
    for (int i = 0; i < count; ++i) text += (i > 0 ? ",\"c" : "\"c") + std::to_string(i) + "\": {}";
    return text + "}}";
  };
  EXPECT_NO_THROW(parseJsonText(withCameras(10000), "s.json"));
  EXPECT_EQ(errorText([&] { parseJsonText(withCameras(100000), "s.json"); }),
            "s.json: cameras: has more than 10000 entries, the most that are read; leave some out");
  std::string list = "{\"probes\": [{\"box\": 1}";
  for (int i = 0; i < 10000; ++i) list += ",0";
  EXPECT_EQ(errorText([&] { parseJsonText(list + "]}", "s.json"); }),
            "s.json: probes: has more than 10000 entries, the most that are read; leave some out");
  EXPECT_NO_THROW(checkJsonSyntax(list + "]}", "model.gltf"));
}

// A key of a megabyte above ten thousand elements took 10 GB of places.
TEST(JsonLimits, ALongKeyIsKeptOnce) {
  std::string text = "{\n\"" + std::string(1 << 20, 'k') + "\": [0";
  for (int i = 1; i < 10000; ++i) text += i == 77 ? ",\n  {\"a/b~\": [5, 6]}" : ",0";
  const JsonText read = parseJsonText(text + "]}", "s.json");
  Json::json_pointer element;
  element.push_back(std::string(1 << 20, 'k'));
  EXPECT_EQ(read.placeText(element), "s.json:2:1");
  element.push_back("77");
  EXPECT_EQ(read.placeText(element), "s.json:3:3");
  EXPECT_EQ(read.placeText(element / "a/b~" / 1), "s.json:3:16");
  EXPECT_EQ(read.placeText(element / "a/b~" / 2), "s.json:3:4") << "the nearest that is there";
}

// Where the library has no std::from_chars for fractions, a stream reads the same from the same text.
TEST(NumberText, AStreamReadsWhatTheLibraryReads) {
  for (const std::string text : {"0",
                                 "-.5",
                                 ".5",
                                 "5.",
                                 "-",
                                 ".",
                                 "-.",
                                 "",
                                 "1e",
                                 "1e+",
                                 "1e-",
                                 "1e5x",
                                 "+1",
                                 " 1",
                                 "0x10",
                                 "1e999",
                                 "-1e999",
                                 "nan",
                                 "-NaN",
                                 "inf",
                                 "-inf",
                                 "Infinity",
                                 "infinit",
                                 "in",
                                 "1,5",
                                 "00012.50e-01",
                                 "123456789.123456789e-12",
                                 "2.2250738585072014e-308",
                                 "1.7976931348623157e308",
                                 "3.14159.5",
                                 "7e0007",
                                 "-0"}) {
    double expected = 12.25, read = 12.25;
    const char* const first = text.data();
    const auto wanted = std::from_chars(first, first + text.size(), expected);
    const auto got = readNumberByStream(first, first + text.size(), read);
    EXPECT_EQ(got.ec, wanted.ec) << text;
    EXPECT_EQ(got.ptr - first, wanted.ptr - first) << text;
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(read)) << text;
    } else {
      EXPECT_EQ(read, expected) << text;
    }
    EXPECT_EQ(std::signbit(read), std::signbit(expected)) << text;
  }
}

}  // namespace
}  // namespace boxprobe
