// An LRU cache of the programs that surfaces have been drawn with: each rest of an edited scene makes programs with its
// own numbers as constants, of some megabytes each with a software driver, and those of edits long past are released.
#pragma once

#include <vtkWeakPointer.h>

#include <cstdint>
#include <unordered_map>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace boxprobe {

class ProgramCache {
 public:
  /// Kept from frame to frame beside those that frames draw with.
  static constexpr std::size_t kMost = 64;

  /// `program`, compiled, is drawn with now; `constants`: it was made for numbers at rest, and no edit draws with it
  /// again. True if it was compiled since the last call with it.
  bool use(vtkShaderProgram* program, bool constants);
  /// Another number after each compilation; 0 if it was given back, or never used.
  std::uint64_t compilation(const vtkShaderProgram* program) const;
  /// Compiled ones.
  std::size_t size() const { return kept_.size(); }
  /// Of those that were not used since the last call, gives back all but `most`: first those with constants, of each
  /// kind those used longest ago. Who draws with one that was given back has it compiled again, by the same text. With
  /// the window's context current. Returns how many; nothing happens where none was used.
  std::size_t trim(vtkOpenGLRenderWindow* window, std::size_t most = kMost);

 private:
  struct Kept {
    vtkWeakPointer<vtkShaderProgram> program;
    std::uint64_t used = 0, compiled = 0;  ///< uses counted by then
    bool constants = false;
  };
  std::unordered_map<const vtkShaderProgram*, Kept> kept_;
  std::uint64_t uses_ = 0, usesTrimmed_ = 0;
};

}  // namespace boxprobe
