// OpenGL's functions, by the loader that VTK was built with: GLEW up to 9.3, GLAD from 9.4 on. To be included before
// any other header of OpenGL, Qt's among them.
#pragma once

#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#define BOXPROBE_HAS_MEMORY_INFO_NVX GLAD_GL_NVX_gpu_memory_info
#define BOXPROBE_HAS_MEMORY_INFO_ATI GLAD_GL_ATI_meminfo
#else
#include <vtk_glew.h>
#define BOXPROBE_HAS_MEMORY_INFO_NVX GLEW_NVX_gpu_memory_info
#define BOXPROBE_HAS_MEMORY_INFO_ATI GLEW_ATI_meminfo
#endif
