// Marks what programs call. Everything else is hidden: a shared library that holds these libraries offers no more.
#pragma once

#if defined(_WIN32)
#define BOXPROBE_EXPORT
#else
#define BOXPROBE_EXPORT __attribute__((visibility("default")))
#endif
