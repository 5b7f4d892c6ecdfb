// What a .gltf file names as one .glb, byte by byte, and what of it is refused.
#include "filters/io/gltf/glb_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;

/// Members in the order of their names.
nlohmann::json sorted(const Json& value) {
  return nlohmann::json::parse(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

class GlbDocuments : public TemporaryFolder {
 protected:
  /// Three buffers of other lengths, one of which readers that decompress do not need, and pictures of every kind.
  static Json beside() {
    return Json::parse(R"({"asset": {"version": "2.0"},
      "buffers": [{"byteLength": 20, "uri": "a.bin", "name": "kept in no file"},
                  {"byteLength": 5, "uri": "data:application/octet-stream;base64,QUJDREU="},
                  {"byteLength": 4000, "extensions": {"EXT_meshopt_compression": {"fallback": true}}},
                  {"byteLength": 33, "uri": "b.bin"}],
      "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 4, "byteLength": 3},
                      {"buffer": 1, "byteLength": 5}, {"buffer": 3, "byteOffset": 7, "byteLength": 9},
                      {"buffer": 2, "byteOffset": 12, "byteLength": 400, "byteStride": 4,
                       "extensions": {"EXT_meshopt_compression": {"buffer": 3, "byteOffset": 2, "byteLength": 30}}},
                      {"buffer": 2, "byteLength": 4, "extensions": {"EXT_meshopt_compression": {"buffer": 1}}}],
      "images": [{"uri": "p.png"}, {"uri": "j.jpg", "name": "photo"}, {"uri": "w.webp"}, {"uri": "k.ktx2"},
                 {"uri": "text.png"}, {"uri": "missing.png"}, {"uri": "DATA:image/png;base64,iVBORw=="},
                 {"bufferView": 0}, {"uri": "short.webp"}, {"uri": "short.ktx2"}, {"uri": "not.webp"}],
      "extensions": {"ACME_any": {"kept": [1, 2.5]}}})");
  }
  void writeFiles() const {
    write("a.bin", "abcdefghijklmnopqrstuvwxyz");
    write("b.bin", std::string(33, 'b') + "behind");
    write("p.png", "\x89PNG of 11\n");
    write("j.jpg", "\xff\xd8 jpeg");
    write("w.webp", std::string("RIFF\1\2\3\4WEBPVP8 ", 16));
    write("k.ktx2", "\xabKTX 20\xbb..");
    write("text.png", "no picture");
    write("short.webp", "RIFF1234WEBP");
    write("short.ktx2", "\xabKTX 20");
    write("not.webp", "RIFF1234WAVE and more");
  }
};

TEST_F(GlbDocuments, JoinWhatTheFileNames) {
  writeFiles();
  const GlbDocument document = readGlbDocument(write("m.gltf", beside().dump()));
  const std::string zeros(64, '\0');
  // Buffers begin at multiples of 16, pictures at multiples of 4.
  const std::string expected = "abcdefghijklmnopqrst" + zeros.substr(0, 12) + "ABCDE" + zeros.substr(0, 11) +
                               std::string(33, 'b') + zeros.substr(0, 15) + "\x89PNG of 11\n" + zeros.substr(0, 1) +
                               "\xff\xd8 jpeg" + zeros.substr(0, 1) + std::string("RIFF\1\2\3\4WEBPVP8 ", 16) +
                               "\xabKTX 20\xbb.." + zeros.substr(0, 2);
  EXPECT_EQ(document.binary, expected);
  const Json wanted = Json::parse(R"({"asset": {"version": "2.0"},
      "buffers": [{}, {"byteLength": 4000, "extensions": {"EXT_meshopt_compression": {"fallback": true}}}],
      "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 4, "byteLength": 3},
                      {"buffer": 0, "byteOffset": 32, "byteLength": 5}, {"buffer": 0, "byteOffset": 55, "byteLength": 9},
                      {"buffer": 1, "byteOffset": 12, "byteLength": 400, "byteStride": 4,
                       "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": 50, "byteLength": 30}}},
                      {"buffer": 1, "byteLength": 4, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": 32}}},
                      {"buffer": 0, "byteOffset": 96, "byteLength": 11}, {"buffer": 0, "byteOffset": 108, "byteLength": 7},
                      {"buffer": 0, "byteOffset": 116, "byteLength": 16}, {"buffer": 0, "byteOffset": 132, "byteLength": 10}],
      "images": [{"bufferView": 6, "mimeType": "image/png"}, {"bufferView": 7, "mimeType": "image/jpeg", "name": "photo"},
                 {"bufferView": 8, "mimeType": "image/webp"}, {"bufferView": 9, "mimeType": "image/ktx2"},
                 {"uri": "text.png"}, {"uri": "missing.png"}, {"uri": "DATA:image/png;base64,iVBORw=="},
                 {"bufferView": 0}, {"uri": "short.webp"}, {"uri": "short.ktx2"}, {"uri": "not.webp"}],
      "extensions": {"ACME_any": {"kept": [1, 2.5]}}})");
  EXPECT_EQ(sorted(document.json), sorted(wanted));
}

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

TEST_F(GlbDocuments, AreWrittenAsTheFormatSays) {
  GlbDocument document;
  document.json = {{"asset", {{"version", "2.0"}}}};
  const std::string path = write("none.glb", glbText(document, "none.glb"));
  std::string text = R"({"asset":{"version":"2.0"}} )";
  EXPECT_EQ(read("none.glb"), "glTF" + word(2) + word(48) + word(28) + "JSON" + text);
  EXPECT_EQ(glbJsonText(path), text);

  document.json["buffers"] = {{{"byteLength", 99}}};
  document.json["name"] = "caf\xc3\xa9 \xff";  // what is no UTF-8 is replaced
  EXPECT_EQ(addBytes(document, "abcde"), 0u);
  EXPECT_EQ(addBytes(document, "fghi"), 1u);
  text = R"({"asset":{"version":"2.0"},"bufferViews":[{"buffer":0,"byteLength":5,"byteOffset":0},{"buffer":0,)"
         R"("byteLength":4,"byteOffset":8}],"buffers":[{"byteLength":12}],"name":"café �"})";
  const std::string written = glbText(document, "some.glb");
  const std::string chunk = *glbJsonText(write("some.glb", written));
  EXPECT_EQ(sorted(Json::parse(chunk)), sorted(Json::parse(text)));
  EXPECT_EQ(chunk.size() % 4, 0u);
  EXPECT_NE(chunk.find("caf\xc3\xa9"), std::string::npos) << "not as an escape";
  const auto size = static_cast<std::uint32_t>(chunk.size());
  EXPECT_EQ(written, "glTF" + word(2) + word(12 + 8 + size + 8 + 12) + word(size) + "JSON" + chunk + word(12) +
                         std::string("BIN\0", 4) + std::string("abcde\0\0\0fghi", 12));
  const GlbDocument again = readGlbDocument(file("some.glb"));
  EXPECT_EQ(again.binary, document.binary + std::string(4, '\0'));
  EXPECT_EQ(again.json["buffers"], Json::array({Json::object()}));
}

TEST_F(GlbDocuments, TheJsonAloneIsReadOfWholeFilesAlone) {
  const std::string chunk = "{\"asset\":1} ";
  const std::string whole = "glTF" + word(2) + word(32) + word(12) + "JSON" + chunk;
  EXPECT_EQ(glbJsonText(write("m.glb", whole)), chunk);
  EXPECT_EQ(glbJsonText(write("m.glb", whole + "behind")), chunk);
  EXPECT_EQ(glbJsonText(write("m.glb", whole.substr(0, 19))), std::nullopt);
  EXPECT_EQ(glbJsonText(write("m.glb", "gltf" + whole.substr(4))), std::nullopt);
  write("m.glb", whole.substr(0, 31));
  EXPECT_EQ(errorText([this] { glbJsonText(file("m.glb")); }),
            file("m.glb") + ": is cut off: its JSON chunk runs past the end; export it again");
  std::string long_ = whole;
  for (const std::size_t at : {13u, 14u, 15u}) {
    long_ = whole;
    long_[at] = 1;
    write("m.glb", long_);
    EXPECT_THAT(errorText([this] { glbJsonText(file("m.glb")); }), HasSubstr("is cut off")) << at;
  }
}

TEST_F(GlbDocuments, MoreBytesThanTheFormatCountsAreRefused) {
  GlbDocument document;
  document.binary = std::string(100, 'x');
  constexpr std::uint64_t kMost = 0xfffffff0u - 28u - 100u;
  EXPECT_NO_THROW(requireGlbSize(document, kMost, "m.glb"));
  EXPECT_THAT(errorText([&] { requireGlbSize(document, kMost + 1, "m.glb"); }),
              HasSubstr("m.glb: would have 4095 MB, and a .glb file counts its bytes in 32 bits: 4095 MB at most"));
}

TEST_F(GlbDocuments, DamageIsSaidWithItsPlace) {
  writeFiles();
  const auto problem = [this](const std::function<void(Json&)>& damage) {
    Json root = beside();
    damage(root);
    const std::string path = write("m.gltf", root.dump());
    return errorText([&] { readGlbDocument(path); }).substr(path.size() + 2);
  };
  const std::string range = " is not a whole number in range; export it again";
  const std::pair<std::function<void(Json&)>, std::string> cases[] = {
      {[](Json& j) { j["buffers"] = 7; }, "buffers: is not a list; export it again"},
      {[](Json& j) { j["buffers"][3]["byteLength"] = -1; }, "buffer 3: byteLength:" + range},
      {[](Json& j) { j["buffers"][1]["byteLength"] = 0xfffffff1u; }, "buffer 1: byteLength:" + range},
      {[](Json& j) { j["buffers"][1]["byteLength"] = 2.0; }, "buffer 1: byteLength:" + range},
      {[](Json& j) { j["buffers"][1]["byteLength"] = 0xfffffff0u; },
       "buffers: have more than 4095 MB together; split the model"},
      {[](Json& j) { j["buffers"][0]["byteLength"] = 27; },
       "buffer 0: has 26 bytes, but byteLength is 27; the file is cut off"},
      {[](Json& j) { j["buffers"][0]["uri"] = 7; }, "buffer 0: uri is not a text; export it again"},
      {[](Json& j) { j["buffers"][2].erase("extensions"); }, "buffer 2: has no uri; export it again"},
      {[](Json& j) { j["bufferViews"][1]["buffer"] = 4; },
       "bufferView 1: has no buffer of that number; export it again"},
      {[](Json& j) { j["bufferViews"][1].erase("buffer"); },
       "bufferView 1: has no buffer of that number; export it again"},
      {[](Json& j) { j["bufferViews"][1]["byteOffset"] = -4; }, "bufferView 1: byteOffset:" + range},
      {[](Json& j) { j["bufferViews"][4]["extensions"]["EXT_meshopt_compression"]["buffer"] = "x"; },
       "bufferView 4: EXT_meshopt_compression: buffer:" + range},
  };
  for (const auto& [damage, message] : cases) EXPECT_EQ(problem(damage), message);
  EXPECT_THAT(problem([](Json& j) { j["buffers"][0]["uri"] = "gone.bin"; }), HasSubstr("does not exist"));
  EXPECT_EQ(problem([](Json& j) { j = Json::array({1}); }), "asset: is missing; is it a glTF file?");
}

}  // namespace
}  // namespace boxprobe
