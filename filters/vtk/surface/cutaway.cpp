#include "filters/vtk/surface/cutaway.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/shared/shader_source.h"

namespace boxprobe {

namespace {

/// A fitted box lies on its walls: what is this much inside of it, of half its size, still counts as wall.
constexpr double kWallShare = 0.02;

}  // namespace

void addCutaway(std::string& fragment) {
  const std::size_t main = fragment.find("void main()");
  const std::size_t body = main == std::string::npos ? main : fragment.find('{', main);
  if (body == std::string::npos) return;
  fragment.insert(body + 1, "\n  if (bpIsCut(vertexVCVSOutput.xyz)) discard;\n");
  fragment.insert(main, shaderSource("gpu/cutaway.glsl"));
}

void uploadCutaway(vtkShaderProgram* program, vtkRenderer* renderer, const CutBox* cut) {
  if (!program->IsUniformUsed("bpCut")) return;
  vtkCamera* camera = renderer->GetActiveCamera();
  program->SetUniformi("bpCut", cut == nullptr ? 0 : camera->GetParallelProjection() != 0 ? 2 : 1);
  if (cut == nullptr) return;
  vtkMatrix4x4* viewFromWorld = camera->GetModelViewTransformMatrix();
  double worldFromView[16];
  vtkMatrix4x4::Invert(viewFromWorld->GetData(), worldFromView);
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(cut->rotationDegrees));
  const glm::dvec3 center = cut->box.center();
  const glm::dvec3 half = glm::max((1.0 - kWallShare) * 0.5 * cut->box.size(), glm::dvec3(1.0e-6));
  float columns[16] = {};  // as OpenGL has them; in double until here, for scenes far from their origin
  for (int column = 0; column < 4; ++column) {
    glm::dvec3 world(worldFromView[column], worldFromView[4 + column], worldFromView[8 + column]);
    if (column == 3) world -= center;
    const glm::dvec3 inBox = boxFromWorld * world / half;
    for (int row = 0; row < 3; ++row) columns[4 * column + row] = static_cast<float>(inBox[row]);
  }
  columns[15] = 1.0f;
  program->SetUniformMatrix4x4("bpCutFromView", columns);
}

}  // namespace boxprobe
