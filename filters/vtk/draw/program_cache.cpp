#include "filters/vtk/draw/program_cache.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <vector>

namespace boxprobe {

namespace {

// Resets what VTK remembers of the program: it would take uniforms of the recompiled program for uploaded, and
// attributes for those of the old one, which vertex arrays keep unless the program has changed.
void giveBack(vtkShaderProgram* program, vtkOpenGLRenderWindow* window) {
  program->ReleaseGraphicsResources(window);
  program->Modified();
  for (const int group : {vtkShaderProgram::CameraGroup, vtkShaderProgram::LightingGroup, vtkShaderProgram::UserGroup})
    program->SetUniformGroupUpdateTime(group, 0);
}

}  // namespace

bool ProgramCache::use(vtkShaderProgram* program, bool constants) {
  Kept& kept = kept_[program];
  // VTK may have deleted a program and created another at the same address.
  const bool compiled = kept.program != program;
  if (compiled) kept.program = program;
  kept.constants = constants;
  kept.used = ++uses_;
  if (compiled) kept.compiled = uses_;
  return compiled;
}

std::uint64_t ProgramCache::compilation(const vtkShaderProgram* program) const {
  const auto kept = kept_.find(program);
  return kept != kept_.end() ? kept->second.compiled : 0;
}

std::size_t ProgramCache::trim(vtkOpenGLRenderWindow* window, std::size_t most) {
  const std::uint64_t since = usesTrimmed_;
  // A frame that draws nothing does not show which programs the picture needs.
  if (uses_ == since) return 0;
  usesTrimmed_ = uses_;
  const auto rests = [since](const auto& each) { return each.second.used <= since; };
  // Checked first: most frames release nothing.
  if (static_cast<std::size_t>(std::count_if(kept_.begin(), kept_.end(), rests)) <= most) return 0;
  std::vector<std::pair<const vtkShaderProgram*, Kept>> old;
  std::copy_if(kept_.begin(), kept_.end(), std::back_inserter(old), rests);
  std::sort(old.begin(), old.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(!a.second.constants, a.second.used) < std::make_tuple(!b.second.constants, b.second.used);
  });
  old.resize(old.size() - most);
  // Releasing unbinds the current program, and the cache has to know.
  window->GetShaderCache()->ReleaseCurrentShader();
  for (const auto& [address, kept] : old) {
    if (kept.program) giveBack(kept.program, window);
    kept_.erase(address);
  }
  return old.size();
}

}  // namespace boxprobe
