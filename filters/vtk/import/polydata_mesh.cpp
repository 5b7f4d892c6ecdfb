#include "filters/vtk/import/polydata_mesh.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/math/cube/srgb.h"
#include "filters/vtk/import/smooth_normals.h"

namespace boxprobe {

namespace {

constexpr double kLargestNumber = 1e18;  // as for glTF: its square does not overflow

[[noreturn]] void failPosition(const std::string& place, std::size_t point) {
  throw InputError(place + ": point " + std::to_string(point) + " is not finite or lies beyond 1e18; repair the model");
}

void checkGeometry(vtkPolyData* data, const std::string& place) {
  const vtkIdType count = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i) {
    double p[3];
    data->GetPoint(i, p);
    for (const double x : p) {
      if (std::fabs(x) <= kLargestNumber) continue;  // also false for NaN
      failPosition(place, static_cast<std::size_t>(i));
    }
  }
  for (vtkCellArray* cells : {data->GetPolys(), data->GetStrips(), data->GetVerts(), data->GetLines()}) {
    if (cells == nullptr) continue;
    vtkNew<vtkIdList> corners;
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
      cells->GetCellAtId(c, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) {
        if (corners->GetId(k) >= 0 && corners->GetId(k) < count) continue;
        throw InputError(place + ": polygon " + std::to_string(c) + " has corner " + std::to_string(corners->GetId(k)) +
                         ", but there are " + std::to_string(count) + " points; the file is damaged");
      }
    }
  }
}

void readColors(vtkPointData* points, Mesh& mesh) {
  for (int a = 0; a < points->GetNumberOfArrays(); ++a) {
    auto* bytes = vtkUnsignedCharArray::SafeDownCast(points->GetArray(a));
    if (bytes == nullptr || bytes->GetNumberOfComponents() < 3 || bytes->GetNumberOfComponents() > 4) continue;
    for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i) {
      glm::vec4 color(1.0f);
      for (int c = 0; c < 3; ++c) color[c] = linearOfSrgb(bytes->GetTypedComponent(i, c));
      if (bytes->GetNumberOfComponents() == 4) color.a = static_cast<float>(bytes->GetTypedComponent(i, 3)) / 255.0f;
      mesh.colors.push_back(color);
    }
    return;
  }
}

}  // namespace

void checkPositions(const std::vector<glm::vec3>& positions, const std::string& place) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::fabs(positions[i][axis]) <= kLargestNumber)) failPosition(place, i);
    }
  }
}

Mesh meshFromPolyData(vtkPolyData* source, const std::string& place) {
  checkGeometry(source, place);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(source);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  vtkPolyData* data = triangles->GetOutput();
  Mesh mesh;
  const vtkIdType count = data->GetNumberOfPoints();
  vtkDataArray* normal = data->GetPointData()->GetNormals();
  vtkDataArray* uv = data->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < count; ++i) {
    double p[3];
    data->GetPoint(i, p);
    mesh.positions.emplace_back(p[0], p[1], p[2]);
    if (normal != nullptr) {
      double n[3];
      normal->GetTuple(i, n);
      const glm::dvec3 v(n[0], n[1], n[2]);
      const double length = glm::length(v);
      // A point with degenerate triangles only, or with NaN in the file: never visible, but must be a unit vector.
      mesh.normals.push_back(length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0, 1, 0));
    }
    if (uv != nullptr && uv->GetNumberOfComponents() >= 2) {
      const double u = uv->GetComponent(i, 0), v = uv->GetComponent(i, 1);
      // In these formats v grows upwards.
      mesh.uv.emplace_back(std::isfinite(u) ? u : 0.0, std::isfinite(v) ? 1.0 - v : 0.0);
    }
  }
  readColors(data->GetPointData(), mesh);
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < data->GetPolys()->GetNumberOfCells(); ++c) {
    data->GetPolys()->GetCellAtId(c, corners);
    if (corners->GetNumberOfIds() != 3) continue;
    for (vtkIdType k = 0; k < 3; ++k) mesh.indices.push_back(static_cast<std::uint32_t>(corners->GetId(k)));
  }
  if (normal == nullptr) computeNormals(mesh);
  return mesh;
}

}  // namespace boxprobe
