#include "filters/vtk/gl/window_pixels.h"

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

ImageRgba8 windowPixels(vtkOpenGLRenderWindow* window) {
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  // VTK 9.1 reads three bytes per pixel into unpadded rows, whatever the alignment: rows of an odd width would overrun
  // the array.
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels, 0);
  ImageRgba8 image{size[0], size[1], {}, {}};
  image.pixels.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * 4);
  for (int y = 0; y < size[1]; ++y) {
    const unsigned char* row = pixels->GetPointer(3 * static_cast<vtkIdType>(size[1] - 1 - y) * size[0]);
    std::uint8_t* out = &image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size[0]) * 4];
    for (std::ptrdiff_t x = 0; x < size[0]; ++x) {
      out[4 * x] = row[3 * x];
      out[4 * x + 1] = row[3 * x + 1];
      out[4 * x + 2] = row[3 * x + 2];
      out[4 * x + 3] = 255;
    }
  }
  return image;
}

}  // namespace boxprobe
