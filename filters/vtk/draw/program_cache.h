// An LRU cache of surface programs. Each edit leaves programs with its own constants behind, several megabytes each
// with a software driver; old ones are released.
#pragma once

#include <vtkWeakPointer.h>

#include <cstdint>
#include <unordered_map>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace boxprobe {

class ProgramCache {
 public:
  /// Programs kept in addition to those that frames draw with.
  static constexpr std::size_t kMost = 64;

  /// Records that the compiled `program` is drawn with now; `constants`: it is specialized, and unlikely to be used
  /// again after an edit. True if it was compiled since the last call with it.
  bool use(vtkShaderProgram* program, bool constants);
  /// A number that changes with each compilation; 0 if the program was released or never used.
  std::uint64_t compilation(const vtkShaderProgram* program) const;
  /// Number of compiled programs.
  std::size_t size() const { return kept_.size(); }
  /// Releases all but `most` of the programs not used since the last call: specialized ones first, each kind by least
  /// recent use. A released program is compiled again when it is next drawn. Needs the window's context current.
  /// Returns how many were released; does nothing if none was used.
  std::size_t trim(vtkOpenGLRenderWindow* window, std::size_t most = kMost);

 private:
  struct Kept {
    vtkWeakPointer<vtkShaderProgram> program;
    std::uint64_t used = 0, compiled = 0;  ///< value of the use counter at the last use, and at the compilation
    bool constants = false;
  };
  std::unordered_map<const vtkShaderProgram*, Kept> kept_;
  std::uint64_t uses_ = 0, usesTrimmed_ = 0;
};

}  // namespace boxprobe
