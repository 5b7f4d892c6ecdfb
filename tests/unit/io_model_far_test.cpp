// Models in coordinates of maps, 431 and 5412 kilometres from the origin: where their points are in double precision.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "filters/vtk/import/model_reader.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

const glm::dvec3 kFar(431000.37, 312.25, 5411932.62);
/// Of a quad without symmetry.
const glm::dvec3 kCorners[4] = {{-0.45, -0.3, 0.1}, {0.45, -0.45, 0.0}, {0.35, 0.45, 0.0}, {-0.45, 0.4, 0.05}};

std::string numbers(const glm::dvec3& p) {
  char text[128];
  std::snprintf(text, sizeof(text), "%.4f %.4f %.4f", p.x, p.y, p.z);
  return text;
}

std::string fileOf(const std::string& extension, const glm::dvec3& at) {
  std::string points[4];
  for (int i = 0; i < 4; ++i) points[i] = numbers(at + kCorners[i]);
  if (extension == "obj") {
    std::string text = "v 1 2 3\n";  // no face uses it
    for (const std::string& p : points) text += "v " + p + "\n";
    return text + "f 2 3 4 5\n";
  }
  if (extension == "ply") {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (const std::string& p : points) text += p + "\n";
    return text + "4 0 1 2 3\n";
  }
  if (extension == "stl") {
    std::string text = "solid x\n";
    for (const auto& t : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      text += "facet normal 0 0 1\nouter loop\n";
      for (const int i : t) text += "vertex " + points[i] + "\n";
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid x\n";
  }
  std::string text =
      R"(<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="4" NumberOfPolys="1">)"
      R"(<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">)";
  for (const std::string& p : points) text += p + " ";
  return text +
         R"(</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>)"
         R"(<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Polys></Piece></PolyData></VTKFile>)";
}

class FarModels : public TemporaryFolder {};

TEST_F(FarModels, PointsStayWhereTheyAre) {
  for (const char* extension : {"obj", "ply", "stl", "vtp"}) {
    const Model model = readModel(write(std::string("m.") + extension, fileOf(extension, kFar)));
    ASSERT_EQ(model.triangleCount(), 2u) << extension;
    const Instance& instance = model.instances.at(0);
    const Mesh& mesh = model.meshes.at(0);
    double worst = 0.0;
    for (const std::uint32_t index : mesh.indices) {
      const glm::dvec3 world(instance.worldFromModel * glm::dvec4(glm::dvec3(mesh.positions[index]), 1.0));
      double nearest = 1e9;
      for (const glm::dvec3& corner : kCorners) nearest = std::min(nearest, glm::distance(world, kFar + corner));
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst, 1e-4) << extension << ": the file has four decimals; in single precision 0.25 is lost";
  }
}

TEST_F(FarModels, MeshesEqualThoseNearTheOrigin) {
  for (const char* extension : {"obj", "ply", "stl", "vtp"}) {
    const Model away = readModel(write(std::string("m.") + extension, fileOf(extension, kFar)));
    const Model here = readModel(write(std::string("m.") + extension, fileOf(extension, glm::dvec3(0.0))));
    EXPECT_EQ(here.instances.at(0).worldFromModel, glm::dmat4(1.0)) << "near ones keep their numbers";
    ASSERT_EQ(away.meshes.at(0).indices, here.meshes.at(0).indices) << extension;
    const glm::vec3 shift = away.meshes[0].positions[0] - here.meshes[0].positions[0];
    for (std::size_t i = 0; i < away.meshes[0].positions.size(); ++i) {
      EXPECT_LT(glm::distance(away.meshes[0].positions[i], here.meshes[0].positions[i] + shift), 2e-4f) << extension;
      EXPECT_LT(glm::distance(away.meshes[0].normals[i], here.meshes[0].normals[i]), 1e-3f) << extension;
    }
  }
}

}  // namespace
}  // namespace boxprobe
