#include "filters/vtk/import/vtp_reader.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/vtk/import/polydata_mesh.h"
#include "filters/vtk/import/vtp_file.h"

namespace boxprobe {

namespace {

/// Ear clipping takes at least quadratic time in the number of corners.
constexpr double kMostVtpCorners = 4096;

class VtpPieces {
 public:
  VtpPieces(const std::string& path, const VtpFile& file) : path_(path), file_(file) {
    data_->SetPoints(points_);
    data_->SetPolys(polys_);
    data_->SetStrips(strips_);
    points_->SetDataTypeToDouble();
    normals_->SetNumberOfComponents(3);
    uv_->SetNumberOfComponents(2);
    colors_->SetNumberOfComponents(4);
  }

  void add(const VtpPiece& piece) {
    if (piece.points == 0) return;
    const VtpArray* points = piece.find("Points", {});
    if (points == nullptr || points->components != 3) failVtp(path_, "has no points of three components");
    const std::vector<double> positions = values(*points, 3 * piece.points);
    const vtkIdType first = points_->GetNumberOfPoints();
    for (std::size_t i = 0; i < positions.size(); i += 3) points_->InsertNextPoint(&positions[i]);
    addCells(piece, "Polys", piece.polys, first, polys_);
    addCells(piece, "Strips", piece.strips, first, strips_);
    addAttributes(piece);
  }

  /// Drops attributes that not all pieces have.
  vtkPolyData* whole() {
    const vtkIdType count = points_->GetNumberOfPoints();
    if (normals_->GetNumberOfTuples() == count) data_->GetPointData()->SetNormals(normals_);
    if (uv_->GetNumberOfTuples() == count) data_->GetPointData()->SetTCoords(uv_);
    if (colors_->GetNumberOfTuples() == count) data_->GetPointData()->AddArray(colors_);
    return data_;
  }

 private:
  std::vector<double> values(const VtpArray& array, std::size_t wanted) const {
    return vtpValues(file_, array, wanted, path_);
  }

  void addCells(const VtpPiece& piece, const std::string& section, std::size_t count, vtkIdType first,
                vtkCellArray* cells) const {
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
      if (size > kMostVtpCorners && section == "Polys") {
        failVtp(path_, "polygon " + std::to_string(i) + " has more than 4096 corners; split it");
      }
      before = offsets[i];
    }
    const std::vector<double> indices = values(*corners, static_cast<std::size_t>(before));
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto end = static_cast<std::size_t>(offsets[i]);
      cells->InsertNextCell(static_cast<int>(end - at));
      for (; at < end; ++at) cells->InsertCellPoint(first + corner(indices[at], i, piece.points));
    }
  }

  vtkIdType corner(double index, std::size_t polygon, std::size_t points) const {
    if (index >= 0.0 && index < static_cast<double>(points)) return static_cast<vtkIdType>(index);
    throw InputError(path_ + ": polygon " + std::to_string(polygon) + " has corner " +
                     std::to_string(static_cast<long long>(std::fmax(std::fmin(index, 1e18), -1e18))) +
                     ", but there are " + std::to_string(points) + " points; the file is damaged");
  }

  void addAttributes(const VtpPiece& piece) {
    for (const VtpArray& array : piece.arrays) {
      if (array.section != "PointData") continue;
      const std::size_t n = array.components;
      if (array.name == piece.normals && n == 3) append(normals_, array, piece.points);
      if (array.name == piece.uv && n >= 2) append(uv_, array, piece.points);
    }
    for (const VtpArray& array : piece.arrays) {
      if (array.section != "PointData" || array.type != "UInt8" || array.components < 3 || array.components > 4)
        continue;
      append(colors_, array, piece.points);
      return;
    }
  }

  /// With the target's number of components; a missing alpha is opaque.
  void append(vtkDataArray* target, const VtpArray& array, std::size_t points) const {
    const std::size_t n = array.components;
    const std::vector<double> numbers = values(array, n * points);
    std::vector<double> tuple(static_cast<std::size_t>(target->GetNumberOfComponents()), 255.0);
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t c = 0; c < std::min(n, tuple.size()); ++c) tuple[c] = numbers[n * i + c];
      target->InsertNextTuple(tuple.data());
    }
  }

  const std::string& path_;
  const VtpFile& file_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polys_, strips_;
  vtkNew<vtkDoubleArray> normals_, uv_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

}  // namespace

Mesh readVtpMesh(const std::string& path, const LoadProgress& progress) {
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
  return meshFromPolyData(pieces.whole(), path);
}

}  // namespace boxprobe
