// The version of the libraries, for #if; CMake reads it from here.
#pragma once

#define BOXPROBE_VERSION_MAJOR 0
#define BOXPROBE_VERSION_MINOR 1
#define BOXPROBE_VERSION_PATCH 0
#define BOXPROBE_VERSION_CHECK(major, minor, patch) (10000 * (major) + 100 * (minor) + (patch))
#define BOXPROBE_VERSION_NUMBER \
  BOXPROBE_VERSION_CHECK(BOXPROBE_VERSION_MAJOR, BOXPROBE_VERSION_MINOR, BOXPROBE_VERSION_PATCH)
