// OpenGL's functions, through VTK's loader: GLEW up to 9.3, GLAD from 9.4 on. Include it before any other OpenGL
// header, including Qt's.
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
