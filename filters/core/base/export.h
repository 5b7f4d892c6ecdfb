// Marks exported symbols. Everything else is hidden, also in a shared library made of these libraries.
#pragma once

#if defined(_WIN32)
#define BOXPROBE_EXPORT
#else
#define BOXPROBE_EXPORT __attribute__((visibility("default")))
#endif
