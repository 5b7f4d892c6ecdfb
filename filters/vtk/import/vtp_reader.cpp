#include "filters/vtk/import/vtp_reader.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/printable_text.h"
#include "filters/io/files/read_budget.h"
#include "filters/io/mesh/polygon_mesh.h"
#include "filters/io/mesh/polygon_triangles.h"
#include "filters/io/obj/obj_text.h"
#include "filters/math/cube/srgb.h"
#include "filters/vtk/import/mesh_model.h"
#include "filters/vtk/import/vtp_file.h"

namespace boxprobe {

namespace {

/// Bytes of three or four components are colours, as VTK draws them; so are other numbers of that name.
bool isColorArray(const VtpArray& array) {
  if (array.components < 3 || array.components > 4) return false;
  if (array.type == "UInt8") return true;
  const std::string name = lowerText(array.name);
  for (const char* known : {"rgb", "rgba", "color", "colors", "colour", "colours"}) {
    if (name == known) return true;
  }
  return false;
}

class VtpPieces {
 public:
  VtpPieces(const std::string& path, const VtpFile& file) : path_(path), file_(file) {
    budget_.allow(file.bytes.size());
  }

  void add(const VtpPiece& piece) {
    if (piece.verts > 0) leftOut_.insert("points");
    if (piece.lines > 0) leftOut_.insert("lines");
    if (piece.points == 0) return;
    const VtpArray* points = piece.find("Points", {});
    if (points == nullptr || points->components != 3) failVtp(path_, "has no points of three components");
    const std::vector<double> numbers = values(*points, 3 * piece.points);
    const std::size_t first = polygons_.positions.size(), firstPolygon = polygons_.ends.size();
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      polygons_.positions.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    addPolygons(piece, first);
    const std::size_t firstStrip = polygons_.ends.size();
    std::vector<std::size_t> stripOf;
    addStrips(piece, first, stripOf);
    addAttributes(piece);
    addCellColors(piece, firstPolygon, firstStrip, stripOf);
  }

  /// Drops attributes that not all pieces have.
  Polygons whole() {
    const auto keep = [&](auto& values, std::size_t count, const char* what) {
      if (values.size() == count) return;
      if (!values.empty()) leftOut_.insert(std::string(what) + " of some pieces");
      values.clear();
    };
    keep(polygons_.normals, polygons_.positions.size(), "normals");
    keep(polygons_.uvs, polygons_.positions.size(), "texture coordinates");
    keep(polygons_.colors, polygons_.positions.size(), "colours");
    keep(polygons_.faceColors, polygons_.ends.size(), "cell colours");
    return std::move(polygons_);
  }

  /// Before meshes are made of them: vertices, of each corner where corners or polygons have values, and triangles.
  void countMeshes(const Polygons& polygons) {
    constexpr std::size_t kVertex = 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + 2 * sizeof(glm::vec4);
    const std::size_t corners = polygons.corners.size();
    const std::size_t vertices = polygons.faceColors.empty() ? polygons.positions.size() : corners;
    countMade(kVertex * vertices + 3 * sizeof(std::uint32_t) * corners, "PolyData");
  }

  const std::set<std::string>& leftOut() const { return leftOut_; }
  bool transparent() const { return transparent_; }

 private:
  std::vector<double> values(const VtpArray& array, std::size_t wanted) {
    constexpr std::size_t kBytes = 2 * sizeof(double);  // what is read, and what is kept of it
    budget_.count(wanted * kBytes, path_ + ": array \"" + printable(array.name.substr(0, 60)) + "\"");
    return vtpValues(file_, array, wanted, path_);
  }

  void countMade(std::size_t bytes, const std::string& section) { budget_.count(bytes, path_ + ": " + section); }

  /// Calls `take` with each cell's corners.
  template <typename Take>
  void forCells(const VtpPiece& piece, const std::string& section, std::size_t count, std::size_t first, Take take) {
    if (count == 0) return;
    const VtpArray *ends = piece.find(section, "offsets"), *corners = piece.find(section, "connectivity");
    if (ends == nullptr || corners == nullptr) failVtp(path_, section + " have no offsets or no connectivity");
    const std::vector<double> offsets = values(*ends, count);
    double before = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double size = offsets[i] - before;
      if (!(size >= 0.0 && size == std::floor(size) && offsets[i] <= 1e9)) {  // also false for NaN
        failVtp(path_, section + ": offset " + std::to_string(i) + " is before the one before it; the file is damaged");
      }
      if (size > static_cast<double>(limits::kPolygonCorners) && section == "Polys") {
        failVtp(path_, "polygon " + std::to_string(i) + " has more than 4096 corners; split it");
      }
      before = offsets[i];
    }
    const auto cornerCount = static_cast<std::size_t>(before);
    const std::vector<double> indices = values(*corners, cornerCount);
    // A corner of a strip ends a triangle.
    constexpr std::size_t kCorner = sizeof(std::uint32_t), kEnd = sizeof(std::size_t);
    countMade(section == "Strips" ? (3 * kCorner + 2 * kEnd) * cornerCount : kCorner * cornerCount + kEnd * count,
              section);
    std::vector<std::uint32_t> cell;
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      cell.clear();
      for (const auto end = static_cast<std::size_t>(offsets[i]); at < end; ++at) {
        cell.push_back(static_cast<std::uint32_t>(first + corner(indices[at], i, piece.points)));
      }
      take(i, cell);
    }
  }

  std::size_t corner(double index, std::size_t polygon, std::size_t points) const {
    if (index >= 0.0 && index < static_cast<double>(points)) return static_cast<std::size_t>(index);
    throw InputError(path_ + ": polygon " + std::to_string(polygon) + " has corner " +
                     std::to_string(static_cast<long long>(std::fmax(std::fmin(index, 1e18), -1e18))) +
                     ", but there are " + std::to_string(points) + " points; the file is damaged");
  }

  void addPolygons(const VtpPiece& piece, std::size_t first) {
    forCells(piece, "Polys", piece.polys, first, [&](std::size_t, const std::vector<std::uint32_t>& cell) {
      polygons_.corners.insert(polygons_.corners.end(), cell.begin(), cell.end());
      polygons_.ends.push_back(polygons_.corners.size());
    });
  }

  /// Each corner forms a triangle with the two before it, with alternating winding.
  void addStrips(const VtpPiece& piece, std::size_t first, std::vector<std::size_t>& stripOf) {
    forCells(piece, "Strips", piece.strips, first, [&](std::size_t strip, const std::vector<std::uint32_t>& cell) {
      for (std::size_t i = 0; i + 2 < cell.size(); ++i) {
        const std::size_t odd = i % 2;
        polygons_.corners.insert(polygons_.corners.end(), {cell[i], cell[i + 1 + odd], cell[i + 2 - odd]});
        polygons_.ends.push_back(polygons_.corners.size());
        stripOf.push_back(strip);
      }
    });
  }

  void addAttributes(const VtpPiece& piece) {
    bool colored = false;
    for (const VtpArray& array : piece.arrays) {
      if (array.section != "PointData") continue;
      const std::size_t n = array.components;
      const std::string name = lowerText(array.name);
      if ((array.name == piece.normals || (piece.normals.empty() && name == "normals")) && n == 3) {
        const std::vector<double> numbers = values(array, n * piece.points);
        for (std::size_t i = 0; i < numbers.size(); i += 3) {
          polygons_.normals.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
        }
      } else if ((array.name == piece.uv ||
                  (piece.uv.empty() && (name == "tcoords" || name == "texturecoordinates"))) &&
                 n >= 2) {
        const std::vector<double> numbers = values(array, n * piece.points);
        for (std::size_t i = 0; i < piece.points; ++i) polygons_.uvs.emplace_back(numbers[n * i], numbers[n * i + 1]);
      } else if (!colored && isColorArray(array)) {
        const std::vector<glm::vec4> colors = colorsOf(array, piece.points);
        polygons_.colors.insert(polygons_.colors.end(), colors.begin(), colors.end());
        colored = true;
      } else {
        leftOut_.insert("point array " + printable(array.name.substr(0, 60)));
      }
    }
  }

  /// Cell data count points and lines first, then polygons, then strips.
  void addCellColors(const VtpPiece& piece, std::size_t firstPolygon, std::size_t firstStrip,
                     const std::vector<std::size_t>& stripOf) {
    bool colored = false;
    for (const VtpArray& array : piece.arrays) {
      if (array.section != "CellData") continue;
      if (colored || !isColorArray(array)) {
        leftOut_.insert("cell array " + printable(array.name.substr(0, 60)));
        continue;
      }
      colored = true;
      const std::size_t before = piece.verts + piece.lines;
      const std::vector<glm::vec4> colors = colorsOf(array, before + piece.polys + piece.strips);
      countMade(sizeof(glm::vec4) * (polygons_.ends.size() - polygons_.faceColors.size()), "CellData");
      polygons_.faceColors.resize(firstPolygon, glm::vec4(1.0f));
      for (std::size_t p = firstPolygon; p < firstStrip; ++p) {
        polygons_.faceColors.push_back(colors[before + p - firstPolygon]);
      }
      for (const std::size_t strip : stripOf) polygons_.faceColors.push_back(colors[before + piece.polys + strip]);
    }
  }

  /// From sRGB: bytes, shares of 1, or, if any is above 1, of 255.
  std::vector<glm::vec4> colorsOf(const VtpArray& array, std::size_t count) {
    const std::size_t n = array.components;
    const std::vector<double> numbers = values(array, n * count);
    const bool bytes =
        array.type == "UInt8" || std::any_of(numbers.begin(), numbers.end(), [](double v) { return v > 1.0; });
    const auto share = [&](double value) { return value >= 0.0 ? std::min(value / (bytes ? 255.0 : 1.0), 1.0) : 0.0; };
    std::vector<glm::vec4> colors;
    bool visible = n == 3;
    for (std::size_t i = 0; i < count; ++i) {
      glm::vec4 color(1.0f);
      for (std::size_t c = 0; c < n; ++c) {
        const double value = share(numbers[n * i + c]);
        color[static_cast<int>(c)] = static_cast<float>(c < 3 ? linearOfSrgbValue(value) : value);
      }
      visible = visible || color.a > 0.0f;
      colors.push_back(color);
    }
    if (!visible && count > 0) {
      leftOut_.insert("an alpha of 0 everywhere");
      for (glm::vec4& color : colors) color.a = 1.0f;
    }
    transparent_ =
        transparent_ || std::any_of(colors.begin(), colors.end(), [](auto& color) { return color.a < 1.0f; });
    return colors;
  }

  const std::string& path_;
  const VtpFile& file_;
  ReadBudget budget_;  ///< pieces may share the bytes of an array
  Polygons polygons_;
  std::set<std::string> leftOut_;
  bool transparent_ = false;
};

}  // namespace

Model readVtp(const std::string& path, const LoadProgress& progress) {
  const auto goOn = [&](double done) {
    if (progress && !progress(done)) throw LoadCancelled(path + ": loading was cancelled");
  };
  const VtpFile file = readVtpFile(path);
  goOn(0.2);
  VtpPieces pieces(path, file);
  for (std::size_t i = 0; i < file.pieces.size(); ++i) {
    pieces.add(file.pieces[i]);
    goOn(0.2 + 0.6 * static_cast<double>(i + 1) / static_cast<double>(file.pieces.size()));
  }
  MeshModel made(path);
  const Polygons polygons = pieces.whole();
  pieces.countMeshes(polygons);
  if (!pieces.leftOut().empty()) {
    std::string text;
    for (const std::string& what : pieces.leftOut()) text += (text.empty() ? "" : ", ") + what;
    made.model().warnings.push_back(leftOutWarning("has data that is not drawn: ", text));
  }
  made.add(polygons, 1, pieces.transparent());
  return made.take();
}

}  // namespace boxprobe
