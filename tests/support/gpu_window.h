// An off-screen OpenGL window for tests, and a way to run shader functions over arrays of inputs on the GPU.
#pragma once

#include <vtkOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace boxprobe::test {

/// Initialised, context current.
vtkSmartPointer<vtkOpenGLRenderWindow> makeWindow(int width = 64, int height = 64, int multiSamples = 0);

/// Runs `body` once for each index of `inputs[0]`, with `in0`, `in1`, ... holding the inputs and `out0`.. to be written
/// (`outputs` of them, at most 4), all vec4, in 32-bit float. `declarations` stands before main. Returns
/// outputs[k][index].
std::vector<std::vector<glm::vec4>> evaluateOnGpu(vtkOpenGLRenderWindow* window, const std::string& declarations,
                                                  const std::string& body,
                                                  const std::vector<std::vector<glm::vec4>>& inputs, int outputs);

}  // namespace boxprobe::test
