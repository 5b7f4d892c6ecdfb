// All values of OBJ, MTL, PLY, STL and VTP files with no two alike, against files in tests/unit/values: what the
// readers make of them, and of each kind of line once a word of it is another one or missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>

#include "tests/unit/model_values.h"

namespace boxprobe {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

std::string joined(const std::vector<std::string>& parts, char by) {
  std::string text;
  for (const std::string& part : parts) text += part + by;
  return text;
}

/// The text with one of its words changed or without one of its lines: of each kind of line the first `most`.
struct Edit {
  std::string name, text;
};
std::vector<Edit> editsOf(const std::string& text, int most) {
  std::vector<Edit> edits;
  const std::vector<std::string> lines = split(text, '\n');
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> words = split(lines[i], ' ');
    const bool key = !words.empty() && !words[0].empty() && std::isalpha(static_cast<unsigned char>(words[0][0])) != 0;
    // Numbers alone are alike if they are as many.
    if (words.empty() || ++seen[key ? words[0] : std::to_string(words.size())] > most) continue;
    const auto add = [&](const std::string& what, const std::vector<std::string>& changed) {
      std::string line = joined(changed, ' ');
      if (!line.empty()) line.pop_back();
      std::vector<std::string> all = lines;
      all[i] = line;
      edits.push_back({std::to_string(i + 1) + " " + what + " '" + line + "'", joined(all, '\n')});
    };
    for (std::size_t w = 0; w < words.size(); ++w) {
      std::vector<std::string> without = words;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(w));
      add("is", without);
      for (const char* other : {"-1", "90", "x"}) {
        std::vector<std::string> changed = words;
        changed[w] = other;
        add("is", changed);
      }
    }
    std::vector<std::string> all = lines;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    edits.push_back({std::to_string(i + 1) + " is gone", joined(all, '\n')});
  }
  return edits;
}

class TextValues : public ModelValues {
 protected:
  TextValues() {
    ImageRgba8 grey{4, 3, {}, "grey"}, sharp{5, 4, {}, "sharp"};
    for (const int level : {10, 40, 90, 30, 200, 120, 15, 75, 60, 250, 33, 140}) {
      const auto value = static_cast<std::uint8_t>(level);
      grey.pixels.insert(grey.pixels.end(), {value, value, value, 255});
    }
    for (int i = 0; i < 20; ++i) {
      const auto value = static_cast<std::uint8_t>(i == 7 ? 100 : i % 3 == 0 ? 255 : 0);
      sharp.pixels.insert(sharp.pixels.end(), {value, 7, 9, static_cast<std::uint8_t>(250 - i)});
    }
    savePng(file("grey.png"), grey);
    savePng(file("sharp.png"), sharp);
  }

  /// What the file becomes after each edit of it.
  std::vector<std::string> editedLines(const std::string& name, const std::string& text, int most) const {
    const Model kept = readModel(write(name, text));  // keeps the pictures decoded
    const std::vector<std::string> before = linesOf(name, text);
    std::vector<std::string> told;
    for (const Edit& edit : editsOf(text, most)) {
      told.push_back(edit.name + ": " + differenceOf(before, linesOf(name, edit.text)));
    }
    return told;
  }

  /// An OBJ file that has a triangle of each material.
  std::string objOf(const std::string& mtl) const {
    std::string obj = "mtllib more.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.9 0.3\nvt 0.4 0.8\n";
    for (const std::string& line : split(mtl, '\n')) {
      if (line.rfind("newmtl ", 0) == 0) obj += "usemtl " + line.substr(7) + "\nf 1/1 2/2 3/3\n";
    }
    return obj;
  }
  /// Of the materials and warnings alone.
  static std::vector<std::string> materialsIn(const std::vector<std::string>& lines) {
    std::vector<std::string> chosen;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(chosen),
                 [](const std::string& line) { return line.rfind("mesh", 0) != 0 && line.rfind("instance", 0) != 0; });
    return chosen;
  }
};

TEST_F(TextValues, OfAnObj) {
  write("whole.mtl", bytesOf("whole.mtl"));
  test::expectKeptValues("unit/values/obj.txt", linesOf("whole.obj", bytesOf("whole.obj")));
  test::expectKeptValues("unit/values/obj_edits.txt", editedLines("whole.obj", bytesOf("whole.obj"), 2));
}

TEST_F(TextValues, OfMaterials) {
  const std::string mtl = bytesOf("more.mtl"), obj = objOf(mtl);
  write("more.mtl", mtl);
  test::expectKeptValues("unit/values/mtl.txt", materialsIn(linesOf("more.obj", obj)));
  std::vector<std::string> told;
  for (const char* name : {"more.mtl", "whole.mtl"}) {
    const std::string text = bytesOf(name), uses = objOf(text);
    write("more.mtl", text);
    const std::vector<std::string> before = materialsIn(linesOf("more.obj", uses));
    const Model kept = readModel(file("more.obj"));
    for (const Edit& edit : editsOf(text, 1)) {
      write("more.mtl", edit.text);
      told.push_back(edit.name + ": " + differenceOf(before, materialsIn(linesOf("more.obj", uses))));
    }
  }
  test::expectKeptValues("unit/values/mtl_edits.txt", told);
}

template <typename Number>
std::string raw(double value, bool big) {
  const auto number = static_cast<Number>(value);
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  if (big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string rawPly(const std::string& type, const std::string& word, bool big) {
  const double value = std::stod(word);
  if (type == "char") return raw<std::int8_t>(value, big);
  if (type == "uchar" || type == "uint8") return raw<std::uint8_t>(value, big);
  if (type == "short") return raw<std::int16_t>(value, big);
  if (type == "ushort" || type == "uint16") return raw<std::uint16_t>(value, big);
  if (type == "int") return raw<std::int32_t>(value, big);
  if (type == "uint") return raw<std::uint32_t>(value, big);
  return type == "double" ? raw<double>(value, big) : raw<float>(value, big);
}

/// The same file with its body in bytes.
std::string binaryPly(const std::string& text, bool big) {
  std::string bytes;
  const std::vector<std::string> lines = split(text, '\n');
  std::vector<std::pair<int, std::vector<std::vector<std::string>>>> elements;
  std::size_t at = 0;
  for (; lines[at] != "end_header"; ++at) {
    const std::vector<std::string> words = split(lines[at], ' ');
    if (words[0] == "element") elements.push_back({std::stoi(words[2]), {}});
    if (words[0] == "property") elements.back().second.push_back(words);
    const bool format = words[0] == "format";
    bytes += (format ? std::string("format binary_") + (big ? "big" : "little") + "_endian 1.0" : lines[at]) + "\n";
  }
  bytes += "end_header\n";
  for (const auto& [count, fields] : elements) {
    for (int i = 0; i < count; ++i) {
      const std::vector<std::string> words = split(lines[++at], ' ');
      std::size_t word = 0;
      for (const std::vector<std::string>& field : fields) {
        const bool list = field[1] == "list";
        const int entries = list ? std::stoi(words[word]) : 1;
        if (list) bytes += rawPly(field[2], words[word++], big);
        for (int k = 0; k < entries; ++k) bytes += rawPly(field[list ? 3 : 1], words[word++], big);
      }
    }
  }
  return bytes;
}

TEST_F(TextValues, OfAPly) {
  std::vector<std::string> kept;
  for (const char* name : {"whole.ply", "types.ply"}) {
    const std::string text = bytesOf(name);
    const std::vector<std::string> lines = linesOf(name, text);
    kept.insert(kept.end(), lines.begin(), lines.end());
    for (const bool big : {false, true}) EXPECT_EQ(linesOf(name, binaryPly(text, big)), lines) << name << big;
  }
  test::expectKeptValues("unit/values/ply.txt", kept);
  std::vector<std::string> told = editedLines("whole.ply", bytesOf("whole.ply"), 2);
  const std::vector<std::string> more = editedLines("types.ply", bytesOf("types.ply"), 1);
  told.insert(told.end(), more.begin(), more.end());
  test::expectKeptValues("unit/values/ply_edits.txt", told);
}

TEST_F(TextValues, OfAnStl) {
  const std::string text = bytesOf("whole.stl");
  std::vector<std::string> kept = linesOf("whole.stl", text);
  // The same triangles as bytes, with the colours of two programs.
  const auto binary = [](std::string header, std::uint32_t promised, std::vector<std::uint16_t> attributes) {
    header.resize(80, ' ');
    std::string bytes = header + raw<std::uint32_t>(promised, false);
    const float numbers[2][9] = {{0.1f, 0.2f, 0.3f, 2.5f, 0.4f, -0.5f, 1.5f, 3.25f, 0.75f},
                                 {0.1f, 0.2f, 0.3f, 1.5f, 3.25f, 0.75f, -1.25f, 2.75f, 4.0f}};
    for (std::size_t t = 0; t < 2; ++t) {
      for (int i = 0; i < 3; ++i) bytes += raw<float>(7 + i, false);  // a normal
      for (const float number : numbers[t]) bytes += raw<float>(number, false);
      bytes += raw<std::uint16_t>(attributes[t], false);
    }
    return bytes;
  };
  EXPECT_EQ(linesOf("whole.stl", binary("made", 2, {0, 0})), kept);
  const auto add = [&](const std::string& what, const std::string& bytes) {
    kept.push_back("== " + what);
    const std::vector<std::string> lines = linesOf("whole.stl", bytes);
    kept.insert(kept.end(), lines.begin(), lines.end());
  };
  const std::string magics = "made COLOR=\x64\xc8\x32";
  add("VisCAM", binary("made", 2, {0x8000 | (30 << 10) | (20 << 5) | 10, 0x8000 | (3 << 10) | (7 << 5) | 13}));
  add("VisCAM, one", binary("made", 2, {0x8000 | (30 << 10) | (20 << 5) | 10, 5}));
  add("Magics", binary(magics + '\xff', 2, {30 | (20 << 5) | (10 << 10), 0x8000}));
  add("Magics, transparent", binary(magics + '\x80', 2, {30 | (20 << 5) | (10 << 10), 0x8000}));
  add("Magics, cut", binary(std::string(71, 'x') + "COLOR=abc", 2, {1, 0x8001}));
  add("none promised", binary("made", 0, {0, 0}));
  add("one promised", binary("made", 1, {0, 0}));
  add("three promised", binary("made", 3, {0, 0}));
  add("solid", binary("solid facet", 2, {0, 0}));
  add("short", "made");
  test::expectKeptValues("unit/values/stl.txt", kept);
  test::expectKeptValues("unit/values/stl_edits.txt", editedLines("whole.stl", text, 2));
}

/// Each attribute is another one or missing, and lists of numbers are longer and shorter.
std::vector<Edit> xmlEditsOf(const std::string& text) {
  std::vector<Edit> edits;
  const auto add = [&](std::size_t from, std::size_t to, const std::string& by) {
    const std::string before = text.substr(0, from);
    const std::size_t element = text.find('<', before.find_last_of("\n") == std::string::npos ? 0 : before.rfind('\n'));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    std::string changed = text.substr(from, std::min<std::size_t>(to - from, 30));
    std::replace(changed.begin(), changed.end(), '\n', ' ');
    edits.push_back({std::to_string(line) + " " + text.substr(element, text.find_first_of(" >", element) - element) +
                         " " + changed + " -> " + by,
                     text.substr(0, from) + by + text.substr(to)});
  };
  // What a reader of XML says of another version is the library's.
  for (std::size_t at = text.find("=\"", text.find("?>")); at != std::string::npos; at = text.find("=\"", at + 2)) {
    const std::size_t key = text.rfind(' ', at) + 1, end = text.find('"', at + 2);
    add(key, end + 1, "");
    for (const char* other : {"7", "0", "ascii", "UInt8"})
      add(key, end + 1, text.substr(key, at - key) + "=\"" + other + "\"");
  }
  for (std::size_t at = text.find("</DataArray>"); at != std::string::npos; at = text.find("</DataArray>", at + 1)) {
    add(at, at, " 1");
    add(text.find_last_of(" >", at) + 1, at, "");
    add(text.find_last_of(" >", at) + 1, at, "-2");
    add(text.find_last_of(" >", at) + 1, at, "4.5");
  }
  for (const char* section : {"PointData", "CellData", "Points", "Polys", "Strips", "Verts", "Lines"}) {
    const std::size_t at = text.find("<" + std::string(section));
    const std::string close = "</" + std::string(section) + ">";
    add(at, text.find(close, at) + close.size(), "");
  }
  return edits;
}

TEST_F(TextValues, OfAVtp) {
  const std::string text = bytesOf("whole.vtp");
  const std::vector<std::string> before = linesOf("whole.vtp", text);
  std::vector<std::string> kept = before;
  // One piece keeps what the other does not have.
  const std::size_t second = text.find("<Piece", text.find("</Piece>"));
  const std::string end = text.substr(text.find("</PolyData>"));
  const auto add = [&](const std::string& what, const std::string& bytes) {
    kept.push_back("== " + what);
    const std::vector<std::string> lines = linesOf("whole.vtp", bytes);
    kept.insert(kept.end(), lines.begin(), lines.end());
  };
  add("first piece", text.substr(0, second) + end);
  add("second piece", text.substr(0, text.find("<Piece")) + text.substr(second));
  test::expectKeptValues("unit/values/vtp.txt", kept);
  std::vector<std::string> told;
  for (const Edit& edit : xmlEditsOf(text)) {
    told.push_back(edit.name + ": " + differenceOf(before, linesOf("whole.vtp", edit.text)));
  }
  test::expectKeptValues("unit/values/vtp_edits.txt", told);
}

}  // namespace
}  // namespace boxprobe
