// See cutaway.h.
#include "filters/vtk/surface/cutaway.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/shared/shader_source.h"
#include "filters/vtk/surface/anchor_edits.h"

namespace boxprobe {

void addCutaway(std::string& fragment, AnchorEdits& edits) {
  edits.insertAtMain(fragment, "cutaway", std::string(shaderSource("gpu/cutaway.glsl")), "\n  BP_CUT\n");
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
  const glm::dvec3 half = cut->halfSize();
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
