#pragma once

#include <cstddef>
#include <cstdint>

/// What a file may count. Beyond a limit a reader refuses the file in one line that names it, before it takes memory
/// for it, unless another rule stands beside the limit. tests/stress/limits.py reads them here and tries those in the
/// table of tests/README.md.
namespace boxprobe::limits {

// Numbers
/// In scene units, units of light or as a factor. Shaders compute in single precision, which ends at 3.4e38: up to this
/// limit the square of a distance, the product of two lights, the extent of a box, and a position after a transform of
/// this size are finite. Materials' numbers beyond it are clamped.
constexpr double kNumber = 1e18;
/// Of geometry in the world, after all transforms. A float still holds the area of a triangle that large.
constexpr double kWorldCoordinate = 1.0e15;

// Scene files
constexpr std::uintmax_t kSceneBytes = 256u << 20;  ///< ten thousand probes with every key take 10 MB
constexpr std::size_t kEntries = 10000;             ///< of each object and list: looking up a member takes linear time
constexpr std::size_t kLampTriangles = 10000;       ///< drawn as shapes, over all objects; more stay in the maps
constexpr std::uintmax_t kProbeFileBytes = 256u << 20;  ///< another program's file with probes

// Lessons
constexpr std::size_t kLessons = 1000;
constexpr std::uintmax_t kLessonBytes = 1 << 20;
constexpr std::uintmax_t kLessonTextBytes = 4 << 20;  ///< of translations
constexpr std::size_t kLessonSteps = 100;             ///< a step starts from the changes of all before it
constexpr std::size_t kCurveValues = 32;              ///< each needs a picture and its reference

// Pictures
constexpr long long kPictureSide = 32768;
/// 2 GiB as float RGBA, a sky of 16384 x 8192.
constexpr long long kPicturePixels = 1LL << 27;
constexpr std::size_t kPictureBytes = 0x7fffffff;  ///< encoded; stb counts them in an int
constexpr int kJpegScans = 500;                    ///< a few bytes can ask for any number over the whole picture
constexpr int kCubeFace = 4096;                    ///< texels along a face of a cubemap that is read or written

// Models
constexpr std::size_t kPolygonCorners = 4096;  ///< ear clipping takes at least quadratic time
/// In one place of the scene, and with an area: a ray through it tries each of them.
constexpr std::size_t kTrianglesInOnePlace = 20000;
constexpr std::size_t kPlyElements = 256;
constexpr std::size_t kPlyTextures = 64;
constexpr std::size_t kVtpPieces = 1000;
constexpr std::size_t kVtpArrays = 1000;           ///< of a piece
constexpr std::uint64_t kGltfBytes = 0xfffffff0u;  ///< both tinygltf and .glb count in 32 bits
/// Meshes at nodes: a file of a few bytes may place the same list of instances at many nodes.
constexpr std::size_t kGltfInstances = std::size_t(1) << 20;
/// Positions moved by morph targets and skins: many small nodes may each deform the same large mesh.
constexpr std::size_t kGltfShapedPositions = std::size_t(1) << 26;
/// Of accessors without bytes (all zero, perhaps with sparse values), whose count no buffer bounds.
constexpr std::size_t kGltfZeroElements = std::size_t(1) << 24;

}  // namespace boxprobe::limits
