#include "filters/vtk/draw/lamp_block.h"

#include <vtkShaderProgram.h>

namespace boxprobe {

void LampBlock::upload(vtkShaderProgram* program, const LampNumbers& numbers) {
  constexpr GLuint kPlace = 1;  // the prefilter's taps have 0
  const auto number = static_cast<GLuint>(program->GetHandle());
  const GLuint block = glGetUniformBlockIndex(number, "bpLampBlock");
  if (block == GL_INVALID_INDEX) return;
  if (handle_ == 0) glGenBuffers(1, &handle_);
  glBindBufferBase(GL_UNIFORM_BUFFER, kPlace, handle_);
  glBufferData(GL_UNIFORM_BUFFER, sizeof numbers, &numbers, GL_STREAM_DRAW);
  glUniformBlockBinding(number, block, kPlace);
}

void LampBlock::release() {
  if (handle_ != 0) glDeleteBuffers(1, &handle_);
  handle_ = 0;
}

}  // namespace boxprobe
