// What one input of a fuzzer is put through, the same for libFuzzer and for the plain test that replays kept inputs.
// Each function returns for an input that is read or refused with an InputError; whatever else a reader throws, or a
// promise of its header that does not hold for what was read, leaves as an exception, which ends both.
#pragma once

#include <stdexcept>
#include <string>

namespace boxprobe::fuzz {

/// Scene JSON: parse, validate, write, read again.
void parseSceneText(const std::string& bytes);
/// EXR and Radiance HDR: as a picture, as a cube of every layout, as a baked probe.
void parseCubeFile(const std::string& bytes);
/// glTF (text) and GLB, with the PNG and JPEG pictures inside.
void parseModelFile(const std::string& bytes);

/// A reader let something through that its header rules out.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};
inline void promise(bool holds, const char* what) {
  if (!holds) throw BrokenPromise(what);
}
/// A refusal is one line of a length that people read.
void checkRefusal(const std::string& message);

}  // namespace boxprobe::fuzz
