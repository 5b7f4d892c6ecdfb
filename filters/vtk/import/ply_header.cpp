#include "filters/vtk/import/ply_header.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"

namespace boxprobe {

namespace {

std::string inQuotes(std::string_view word) {
  return "\"" + std::string(word) + "\"";
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

class HeaderReader {
 public:
  HeaderReader(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

  PlyHeader read() {
    if (!nextLine() || words_.size() != 1 || words_[0] != "ply") {
      failPly(path_, 1, "does not start with a line \"ply\"; is it a PLY file?");
    }
    for (;;) {
      if (!nextLine()) failPly(path_, 0, "has no end_header; the file is cut off");
      if (words_.empty()) fail("the header has an empty line; delete it");
      const std::string_view word = words_[0];
      if (word == "comment" || word == "obj_info") {
        readComment();
        continue;
      }
      checkLine();
      if (word == "end_header") break;
      if (word == "format") {
        readFormat();
      } else if (word == "element") {
        readElement();
      } else if (word == "property") {
        readProperty();
      }
      // Other lines are taken as comments: Blender 2.4 wrote "Created by ..." without that word.
    }
    checkWhole();
    header_.lines = line_;
    // Lines that end with both, the wrong way round: the last one ends before the body.
    if (bytes_.compare(0, 5, "ply\n\r") == 0 && next_ < bytes_.size() && bytes_[next_] == '\r') ++next_;
    header_.body = next_;
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { failPly(path_, line_, reason); }

  /// False at the end of the file. Ignores a last line without a line end.
  bool nextLine() {
    ++line_;
    begin_ = next_;
    end_ = bytes_.find('\n', begin_);
    if (end_ == std::string::npos) return false;
    next_ = end_ + 1;
    splitPlyLine(std::string_view(bytes_).substr(begin_, end_ - begin_), words_);
    return true;
  }

  void checkLine() const {
    const std::string_view text = std::string_view(bytes_).substr(begin_, end_ - begin_);
    if (text.size() > kLongestPlyLine) {
      fail("the line is longer than " + std::to_string(kLongestPlyLine) + " characters; shorten it");
    }
    if (text.find('\0') != std::string_view::npos) fail("is not text; the file is damaged");
  }

  /// As MeshLab and others name a picture.
  void readComment() {
    if (words_.size() < 3 || words_[1] != "TextureFile" || header_.textures.size() == limits::kPlyTextures) return;
    const char* first = words_[2].data();
    header_.textures.emplace_back(first, words_.back().data() + words_.back().size());
  }

  void readFormat() {
    if (words_.size() != 3) fail("the format line is not complete; write \"format ascii 1.0\" if the body is text");
    if (formatLine_ > 0) fail("is a second format line after line " + std::to_string(formatLine_) + "; delete one");
    formatLine_ = line_;
    if (words_[1] == "ascii") {
      header_.format = PlyFormat::Text;
    } else if (words_[1] == "binary_little_endian") {
      header_.format = PlyFormat::LittleEndian;
    } else if (words_[1] == "binary_big_endian") {
      header_.format = PlyFormat::BigEndian;
    } else {
      fail(inQuotes(words_[1]) + " is not a format; ascii, binary_little_endian and binary_big_endian are");
    }
    if (words_[2] != "1.0") fail("version " + inQuotes(words_[2]) + " is not supported; save the file as PLY 1.0");
  }

  void readElement() {
    if (words_.size() != 3) fail("the element line is not complete; write \"element NAME COUNT\"");
    PlyElementHead element;
    element.name = words_[1];
    element.line = line_;
    const std::string name = inQuotes(element.name);
    for (const PlyElementHead& other : header_.elements) {
      if (other.name != element.name) continue;
      fail("element " + name + " stands in line " + std::to_string(other.line) + " already; join the two");
    }
    if (header_.elements.size() == limits::kPlyElements) {
      fail("has more than " + std::to_string(limits::kPlyElements) +
           " elements; delete those that are not vertex or face");
    }
    long long count = 0;
    const std::string_view digits = words_[2];
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
      fail(inQuotes(digits) + " is not a count of " + name + "; write a whole number");
    }
    if (count < 0) fail("promises " + std::string(digits) + " of " + name + "; a count is 0 or more");
    // Each entry takes at least one byte.
    if (error == std::errc::result_out_of_range || count > std::numeric_limits<int>::max() ||
        static_cast<unsigned long long>(count) > bytes_.size() - next_) {
      fail("promises " + std::string(digits) + " of " + name + ", more than the file holds; the file is cut off");
    }
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  PlyType typeOf(std::string_view word) const {
    static const std::pair<std::string_view, PlyType> names[] = {
        {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
        {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
        {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
        {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
        {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
        {"float64", PlyType::Float64}};
    for (const auto& [name, type] : names) {
      if (name == word) return type;
    }
    fail(inQuotes(word) + " is not a type; write char, uchar, short, ushort, int, uint, float or double");
  }

  void readProperty() {
    if (header_.elements.empty()) fail("the property stands before any element; move it behind its element line");
    const bool list = words_.size() > 1 && words_[1] == "list";
    if (words_.size() != (list ? 5u : 3u)) {
      fail("the property line is not complete; write \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
    }
    PlyField field;
    field.isList = list;
    field.name = words_.back();
    if (field.name == "vertex_index") field.name = "vertex_indices";
    field.type = typeOf(words_[list ? 3 : 1]);
    if (list) field.countType = typeOf(words_[2]);
    const bool vertex = header_.elements.back().name == "vertex", face = header_.elements.back().name == "face";
    const bool number =
        vertex ? isOneOf(field.name, {"x", "y", "z", "u", "v", "s", "t", "texture_u", "texture_v", "nx", "ny", "nz",
                                      "red", "green", "blue", "alpha", "diffuse_red", "diffuse_green", "diffuse_blue"})
               : isOneOf(field.name, {"texnumber", "red", "green", "blue", "alpha"});
    if ((vertex || face) && number && list)
      fail(inQuotes(field.name) + " is a list where a number is needed; save the file again");
    if (face && !list && isOneOf(field.name, {"vertex_indices", "texcoord"})) {
      fail(inQuotes(words_.back()) + " is a number where a list is needed; save the file again");
    }
    header_.elements.back().fields.push_back(std::move(field));
  }

  void checkWhole() const {
    if (formatLine_ == 0) fail("has no format line; write \"format ascii 1.0\" below \"ply\" if the body is text");
    bool hasVertex = false;
    for (const PlyElementHead& element : header_.elements) {
      const auto has = [&](std::string_view name) {
        return std::any_of(element.fields.begin(), element.fields.end(), [&](const auto& f) { return f.name == name; });
      };
      if (element.fields.empty()) {
        failPly(path_, element.line, "element " + inQuotes(element.name) + " has no properties; delete it");
      }
      if (element.name == "vertex") {
        hasVertex = true;
        for (const char* axis : {"x", "y", "z"}) {
          if (has(axis)) continue;
          failPly(path_, element.line, "\"vertex\" has no property " + inQuotes(axis) + "; save the file again");
        }
      }
      if (element.name == "face" && !has("vertex_indices")) {
        failPly(path_, element.line,
                "\"face\" has no list of corners; name it \"vertex_indices\", as in \"property list uchar int "
                "vertex_indices\"");
      }
    }
    if (!hasVertex) fail("has no element \"vertex\"; save the file again");
  }

  const std::string& path_;
  const std::string& bytes_;
  PlyHeader header_;
  std::vector<std::string_view> words_;
  std::size_t line_ = 0, begin_ = 0, end_ = 0, next_ = 0, formatLine_ = 0;
};

}  // namespace

std::size_t sizeInBytes(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
      return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
      return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      break;
  }
  return 8;
}

void failPly(const std::string& path, std::size_t line, const std::string& reason) {
  throw InputError(oneLine(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + reason));
}

void splitPlyLine(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  constexpr std::string_view kBetween = " \t\r";
  for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBetween, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBetween, end);
  }
}

PlyHeader readPlyHeader(const std::string& path, const std::string& bytes) {
  return HeaderReader(path, bytes).read();
}

}  // namespace boxprobe
