// The decoders of glTF, PNG, JPEG and Radiance HDR compiled from their headers: for fuzzers, as the system's libraries
// are not instrumented and libFuzzer would be blind to most of what an input reaches, and where the system has headers
// alone.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
