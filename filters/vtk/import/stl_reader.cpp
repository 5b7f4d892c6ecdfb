#include "filters/vtk/import/stl_reader.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

namespace {

constexpr std::size_t kStlHeader = 84, kStlTriangle = 50;

[[noreturn]] void failStl(const std::string& path, const std::string& place, const std::string& reason) {
  throw InputError(oneLine(path + place + ": " + reason));
}

/// The count in a binary file's header. STL is little-endian, as are the supported processors.
std::size_t promisedTriangles(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kStlHeader - sizeof count, sizeof count);
  return count;
}

bool isStlWord(std::string_view word, std::string_view wanted) {
  if (word.size() != wanted.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(word[i])) != wanted[i]) return false;
  }
  return true;
}

/// Some binary files also start with "solid": detected by their size.
bool isStlText(const std::string& bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || !isStlWord(std::string_view(bytes).substr(start, 5), "solid")) return false;
  if (bytes.find("facet") == std::string::npos && bytes.find("FACET") == std::string::npos) return false;
  return bytes.size() < kStlHeader || bytes.size() != kStlHeader + kStlTriangle * promisedTriangles(bytes);
}

class StlProgress {
 public:
  StlProgress(const std::string& path, const LoadProgress& progress) : path_(path), progress_(progress) {}
  void triangle(double done) {
    constexpr std::size_t kBetween = 1 << 16;
    if (++triangles_ % kBetween == 0 && progress_ && !progress_(0.8 * done)) {
      throw LoadCancelled(path_ + ": loading was cancelled");
    }
  }

 private:
  const std::string& path_;
  const LoadProgress& progress_;
  std::size_t triangles_ = 0;
};

void addStlVertex(Mesh& mesh, const glm::vec3& position) {
  mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
  mesh.positions.push_back(position);
}

void readStlBinary(const std::string& path, const std::string& bytes, StlProgress& progress, Mesh& mesh) {
  if (bytes.size() < kStlHeader) failStl(path, "", "is cut off: a binary STL file has a header of 84 bytes");
  const std::size_t count = promisedTriangles(bytes), held = (bytes.size() - kStlHeader) / kStlTriangle;
  if (count == 0) failStl(path, "", "has no triangles");
  if (count > held) {
    failStl(path, "",
            "promises " + std::to_string(count) + " triangles, but holds " + std::to_string(held) +
                "; the file is cut off");
  }
  mesh.positions.reserve(3 * count);
  mesh.indices.reserve(3 * count);
  for (std::size_t t = 0; t < count; ++t) {
    float numbers[9];  // after the normal
    std::memcpy(numbers, bytes.data() + kStlHeader + kStlTriangle * t + 12, sizeof numbers);
    for (std::size_t k = 0; k < 9; k += 3) addStlVertex(mesh, {numbers[k], numbers[k + 1], numbers[k + 2]});
    progress.triangle(static_cast<double>(t) / static_cast<double>(count));
  }
}

/// The words of a text with their line numbers. Carriage returns alone also end lines.
class StlWords {
 public:
  explicit StlWords(const std::string& bytes) : bytes_(bytes) {}

  /// Empty at the end.
  std::string_view next() {
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) step();
    const std::size_t start = at_;
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) == 0) ++at_;
    return std::string_view(bytes_).substr(start, at_ - start);
  }
  void skipLine() {
    while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
  }
  std::string place() const { return ":" + std::to_string(line_); }
  double done() const { return static_cast<double>(at_) / static_cast<double>(bytes_.size()); }

 private:
  void step() {
    const bool pair = bytes_[at_] == '\r' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n';
    if (bytes_[at_] == '\n' || (bytes_[at_] == '\r' && !pair)) ++line_;
    ++at_;
  }

  const std::string& bytes_;
  std::size_t at_ = 0, line_ = 1;
};

void readStlText(const std::string& path, const std::string& bytes, StlProgress& progress, Mesh& mesh) {
  StlWords words(bytes);
  const auto number = [&] {
    std::string_view word = words.next();
    const std::string told(word.substr(0, 40));
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    float value = 0.0f;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec == std::errc::invalid_argument || result.ptr != word.data() + word.size()) {
      failStl(path, words.place(), "\"" + told + "\" is not a number; \"vertex\" has three");
    }
    return result.ec == std::errc() ? value : 0.0f;  // underflow, or overflow, which no real model has
  };
  std::size_t corners = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (isStlWord(word, "solid") || isStlWord(word, "endsolid")) {
      words.skipLine();  // the name
    } else if (isStlWord(word, "vertex")) {
      const float x = number(), y = number(), z = number();
      addStlVertex(mesh, {x, y, z});
      ++corners;
    } else if (isStlWord(word, "endloop")) {
      if (corners != 3) {
        failStl(path, words.place(), "the loop has " + std::to_string(corners) + " vertices; STL has triangles alone");
      }
      corners = 0;
      progress.triangle(words.done());
    } else if (isStlWord(word, "facet")) {
      words.skipLine();  // its normal
    } else if (!isStlWord(word, "outer") && !isStlWord(word, "loop") && !isStlWord(word, "endfacet")) {
      failStl(path, words.place(), "\"" + std::string(word.substr(0, 40)) + "\" is not of STL; the file is damaged");
    }
  }
  if (corners != 0) failStl(path, words.place(), "the file ends within a loop; it is cut off");
}

}  // namespace

Mesh readStlMesh(const std::string& path, const LoadProgress& progress) {
  const std::string bytes = readWholeFile(path);
  StlProgress reported(path, progress);
  Mesh mesh;
  if (isStlText(bytes)) {
    readStlText(path, bytes, reported, mesh);
  } else {
    readStlBinary(path, bytes, reported, mesh);
  }
  return mesh;
}

}  // namespace boxprobe
