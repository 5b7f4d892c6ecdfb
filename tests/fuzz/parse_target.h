// What one input of a fuzzer is put through, the same for libFuzzer and for the plain test that replays kept inputs.
// Each function returns for an input that is read or refused with an InputError; whatever else a reader throws, or a
// promise of its header that does not hold for what was read, leaves as an exception, which ends both.
#pragma once

#include <stdexcept>
#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe::fuzz {

/// Scene JSON: parse, validate, write, read again.
void parseSceneText(const std::string& bytes);
/// EXR and Radiance HDR: as a picture, as a cube of every layout, as a baked probe.
void parseCubeFile(const std::string& bytes);
/// Scenes of Unity and Godot, for their probes.
void parseEngineText(const std::string& bytes);
/// Lessons with their texts in them: each step can run, or the lesson is refused.
void parseLessonText(const std::string& bytes);
/// Models that are not glTF, each with its own extension.
void parseObjFile(const std::string& bytes);
void parsePlyFile(const std::string& bytes);
void parseStlFile(const std::string& bytes);
void parseVtpFile(const std::string& bytes);
/// What every mesh that was read must hold; throws BrokenPromise.
void checkMesh(const Mesh& mesh, std::size_t materials);
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
