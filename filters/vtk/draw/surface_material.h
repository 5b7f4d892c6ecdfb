// A material for surface programs: its textures, and the attributes of its vertices. Made by model_actors.cpp, read for
// uniforms and shader variants.
#pragma once

#include <array>
#include <glm/mat3x2.hpp>
#include <memory>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/vtk/draw/glass_surface.h"
#include "filters/vtk/gl/mip_levels.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

/// A picture with mip levels, uploaded at the first draw that needs it. VTK 9.1's own textures have one wrap mode for
/// both axes and keep a second copy of the pixels.
class SurfaceTexture {
 public:
  /// `mips` makes the levels; textures share it.
  SurfaceTexture(const TextureUse& use, bool srgb, std::shared_ptr<MipLevels> mips);
  ~SurfaceTexture() { release(); }
  SurfaceTexture(const SurfaceTexture&) = delete;
  SurfaceTexture& operator=(const SurfaceTexture&) = delete;

  /// The context must be current, also for release().
  GLuint handle() const;
  void release() const;
  /// GPU memory including mip levels; 0 before the upload.
  std::size_t bytes() const;

  const ImageRgba8& image() const { return *image_; }
  Wrap wrap() const { return wrapS_; }  ///< along s
  bool srgb() const { return srgb_; }

 private:
  std::shared_ptr<const ImageRgba8> image_;
  std::shared_ptr<MipLevels> mips_;
  Wrap wrapS_, wrapT_;
  bool srgb_, nearest_;
  mutable GLuint handle_ = 0;
};

struct SurfaceSlot {
  std::shared_ptr<const SurfaceTexture> texture;
  int uvSet = 0;
  glm::mat3x2 uvTransform{1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};
};

enum SurfaceSlotIndex {
  kBaseColorSlot,
  kRoughMetalSlot,
  kNormalSlot,
  kOcclusionSlot,
  kEmissiveSlot,
  kCoatSlot,
  kCoatRoughnessSlot,
  kCoatNormalSlot,
  kTransmissionSlot,
  kThicknessSlot,
  kSpecularSlot,
  kSpecularColorSlot,
  kSheenColorSlot,
  kSheenRoughnessSlot,
  kAnisotropySlot,
  kIridescenceSlot,
  kFilmThicknessSlot,
  kSurfaceSlots
};
/// Their names in shaders.
const std::array<const char*, kSurfaceSlots>& surfaceSlotNames();

struct SurfaceMaterial {
  std::array<SurfaceSlot, kSurfaceSlots> slots;
  std::array<bool, 2> uv{};  ///< which sets of coordinates the textures use
  bool colors = false;
  bool tangents = false;
  bool unlit = false;
  AlphaMode alphaMode = AlphaMode::Opaque;
  float alpha = 1.0f;
  float alphaCutoff = 0.5f;
  float normalScale = 1.0f;
  float coatNormalScale = 1.0f;
  float thicknessScale = 1.0f;  ///< 1 / mean of the thickness texture
  GlassSurface glass;
  MaterialFinish finish;

  /// Does its program draw a finish? Materials that transmit light have none.
  bool finished() const { return finish.any() && !unlit && !glass.drawn; }
  bool brushed() const { return finished() && finish.isAnisotropic() && tangents; }

  /// The key of its program without facts: equal texts share one.
  std::string programKey() const;
};

}  // namespace boxprobe
