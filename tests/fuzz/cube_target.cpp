// Pictures of the surroundings: whatever is accepted is finite, within half range where that is promised, and a baked
// probe that was read is written and read again to the same texels.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/image/image_file.h"
#include "tests/fuzz/parse_target.h"
#include "tests/fuzz/scratch_file.h"

namespace boxprobe::fuzz {

namespace {

// Clamped to the largest half, 65504, before resampling, whose rounding may add a little: below 65520 a half is still
// that largest one.
constexpr float kHalfMax = 65519.0f;
constexpr int kSmallFace = 4;  // explicit: resampling a large cube would take most of the time
constexpr std::size_t kManyTexels = 1024;
constexpr int kSavedFace = 16;  // the largest whose round trip is worth its time

/// Every texel of every level within `limit`; NaN fails the comparison.
bool within(const CubeMap& cube, float limit) {
  for (int level = 0; level < cube.levels(); ++level) {
    const int count = 6 * 4 * cube.levelSize(level) * cube.levelSize(level);
    const float* values = cube.face(level, 0);
    if (!std::all_of(values, values + count, [limit](float v) { return std::fabs(v) <= limit; })) return false;
  }
  return true;
}

bool same(const CubeMap& a, const CubeMap& b) {
  if (a.faceSize() != b.faceSize() || a.levels() != b.levels()) return false;
  for (int level = 0; level < a.levels(); ++level) {
    const int count = 6 * 4 * a.levelSize(level) * a.levelSize(level);
    if (!std::equal(a.face(level, 0), a.face(level, 0) + count, b.face(level, 0))) return false;
  }
  return true;
}

template <typename Read>
void accepted(const Read& read) {
  try {
    read();
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
  }
}

void checkCube(const std::string& path, CubeLayout layout, int faceSize) {
  accepted([&] {
    const LoadedCube cube = loadCube(path, layout, faceSize);
    promise(!cube.radiance.empty(), "an accepted cube is empty");
    promise(faceSize == 0 || cube.radiance.faceSize() == faceSize, "a cube has another size than asked for");
    promise(within(cube.radiance, kHalfMax), "a cube has texels beyond half range");
    promise(cube.layout != CubeLayout::Automatic, "an accepted cube has no layout");
    if (cube.distance.empty()) return;
    promise(within(cube.distance, std::numeric_limits<float>::max()), "a cube's distances are not finite");
  });
}

void checkBaked(const ScratchFile& scratch, const std::string& path, bool roundTrip) {
  const bool claimsToBe = bakedProbeMark(path).has_value();
  accepted([&] {
    const BakedProbeFile file = loadBakedProbe(path);
    promise(claimsToBe, "a baked probe is read that has no hash");
    promise(within(file.maps.radiance, std::numeric_limits<float>::max()), "a baked probe's maps are not finite");
    (void)BakeRecord::parse(file.info.inputHash);
    if (!roundTrip || file.maps.radiance.faceSize() > kSavedFace) return;
    try {
      const std::string copy = scratch.path("copy.exr");
      saveBakedProbe(copy, file, ExrPrecision::Float);
      const BakedProbeFile again = loadBakedProbe(copy);
      promise(same(again.maps.radiance, file.maps.radiance), "a baked probe's maps change when written");
      promise(again.info.probe == file.info.probe, "a baked probe's fields change when written");
    } catch (const WorkError& refused) {  // faces that are no power of two are read for what they are, not written
      checkRefusal(refused.what());
    }
  });
}

}  // namespace

void parseCubeFile(const std::string& bytes) {
  static const ScratchFile scratch;
  // The magic numbers of OpenEXR and of everything else: the readers go by extension.
  const bool exr = bytes.compare(0, 4, "\x76\x2f\x31\x01") == 0;
  const std::string extension = exr ? ".exr" : ".hdr";
  const std::string path = scratch.write("face_px" + extension, bytes);
  // A square picture is all six faces, under the six names.
  for (const char* face : {"nx", "py", "ny", "pz", "nz"}) {
    std::error_code exists;
    std::filesystem::create_symlink(path, scratch.path(std::string("face_") + face + extension), exists);
  }
  std::size_t texels = 0;
  accepted([&] {
    std::size_t notFinite = 0;
    const ImageRgbaF image = loadHdrImage(path, &notFinite);
    promise(std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return std::isfinite(v); }),
            "a picture's texels are not finite");
    promise(image.pixels.size() == std::size_t(4) * image.width * image.height, "a picture has another size");
    texels = image.pixels.size() / 4;
  });
  // Resampling takes time by the texel and shows nothing more with more of them: of large pictures one in sixteen goes
  // on.
  if (texels > kManyTexels && bytes.size() % 16 != 0) return;
  // The size the picture itself gives, for some inputs: that costs time. One layout each: an input's neighbours have
  // others.
  constexpr CubeLayout kLayouts[] = {CubeLayout::Automatic, CubeLayout::LatLong, CubeLayout::Strip, CubeLayout::Cross};
  checkCube(path, kLayouts[bytes.size() % 4], bytes.size() % 11 == 0 ? 0 : kSmallFace);
  if (exr) checkBaked(scratch, path, bytes.size() % 5 == 0);  // writing takes ten times as long as reading
}

}  // namespace boxprobe::fuzz
