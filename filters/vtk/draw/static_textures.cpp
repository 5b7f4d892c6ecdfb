#include "filters/vtk/draw/static_textures.h"

#include <vtkOpenGLRenderWindow.h>

#include "filters/math/sampling/blue_noise.h"
#include "filters/math/sampling/brdf_table.h"

namespace boxprobe {

void makeStaticTextures(vtkOpenGLRenderWindow* window, SceneResources& resources, FrameCounts& counts) {
  if (resources.brdfTable != 0) return;
  counts.fail(seamlessCubesProblem());
  glGenTextures(1, &resources.brdfTable);
  {
    const BoundTexture bound(window, GL_TEXTURE_2D, resources.brdfTable);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16, kBrdfTableSize, kBrdfTableSize, 0, GL_RG, GL_UNSIGNED_SHORT, kBrdfTable);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glGenTextures(1, &resources.blackCube);
  const BoundTexture bound(window, GL_TEXTURE_CUBE_MAP, resources.blackCube);
  const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA16F, 1, 1, 0, GL_RGBA, GL_FLOAT, black);
  }
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 0);
}

void uploadSplitSumTable(vtkOpenGLRenderWindow* window, GLuint texture, int columns, int rows,
                         const std::vector<glm::vec2>& table) {
  const BoundTexture bound(window, GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, columns, rows, 0, GL_RG, GL_FLOAT, table.data());
}

void makeBlueNoise(vtkOpenGLRenderWindow* window, SceneResources& resources) {
  if (resources.blueNoise != 0) return;
  glGenTextures(1, &resources.blueNoise);
  const BoundTexture bound(window, GL_TEXTURE_2D, resources.blueNoise);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, kBlueNoiseSize, kBlueNoiseSize, 0, GL_RG, GL_FLOAT, blueNoise().data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void releaseStaticTextures(SceneResources& resources) {
  glDeleteTextures(1, &resources.brdfTable);
  glDeleteTextures(1, &resources.blackCube);
  glDeleteTextures(1, &resources.blueNoise);
  glDeleteTextures(1, &resources.viewColors);
  resources.brdfTable = resources.blackCube = resources.blueNoise = resources.viewColors = 0;
}

}  // namespace boxprobe
