// Kinds, status bits and cell arrays of the lines that vtkProjectionRays outputs, for code that draws them and for
// readers of a saved .vtp.
#pragma once

#include <string_view>

namespace boxprobe {

/// Array "kind". P surface point, N normal, R reflection, C capture origin, H hit on the probe's proxy.
enum class RayKind : int {
  Eye = 0,        ///< eye to P; parallel projection: against the view direction, with MaximumLength
  Normal = 1,     ///< P along N, with NormalLength
  Reflected = 2,  ///< P to H; MaximumLength along R without a proxy
  Lookup = 3,     ///< C to the sampled position (H - C for box projection), one per lookup
  Sample = 4,     ///< P to the sampled position, for techniques that sample something other than H
  TrueHit = 5,    ///< P along R to the scene itself
  Error = 6,      ///< H to the true hit
  Within = 7,     ///< glass: from P through it to the exit, one line per internal reflection
  Refracted = 8,  ///< glass: from the exit to H; MaximumLength without a proxy
  Shadow = 9,     ///< P towards a light that casts shadows, to the exit from the probe's box
};
inline constexpr int kRayKinds = 10;
inline constexpr std::string_view kRayKindNames[kRayKinds] = {
    "eye ray",  "normal", "reflected ray", "lookup",        "sample",
    "true hit", "error",  "within glass",  "refracted ray", "shadow ray"};

/// Array "status": 0, or the sum of unusual conditions at the point, or between point and probe.
enum RayStatus : int {
  kRayNoNormal = 1,        ///< normal missing, zero or not finite: only the eye ray is drawn
  kRayEyeOnPoint = 2,      ///< no direction to the eye: only the normal is drawn
  kRayFromBehind = 4,      ///< N.V <= 0: the eye is behind the surface, and R goes straight on
  kRayNoProxy = 8,         ///< the technique has no proxy (infinite, normal, projection off): no hit, no error
  kRayPointOutside = 16,   ///< P outside the projection box: H is clamped to it
  kRayOriginOutside = 32,  ///< C outside the projection box: one direction corresponds to two places on it
  kRayNoProbe = 64,        ///< no probe's influence reaches P: the sky is sampled along R
};

// Cell arrays. -1 means undefined (no hit, no probe, no box): values are never NaN or infinite.
namespace ray_array {
inline constexpr const char* kKind = "kind";                  // int
inline constexpr const char* kStatus = "status";              // int
inline constexpr const char* kPoint = "point";                // int, index of the input point
inline constexpr const char* kProbe = "probe";                // int, index of the probe
inline constexpr const char* kFace = "face";                  // int, 0..5: -x +x -y +y -z +z of the box
inline constexpr const char* kHitPoint = "hitPoint";          // 3 double, world; the line's end without a hit
inline constexpr const char* kHitDistance = "hitDistance";    // double, P to H, scene units
inline constexpr const char* kDirection = "lookupDirection";  // 3 double, probe's axes, as passed to the map, not unit
inline constexpr const char* kLevel = "level";                // double, of the prefiltered chain
inline constexpr const char* kWeight = "weight";              // double, the probe's share of the point, 0..1
inline constexpr const char* kLookupShare = "lookupShare";    // double, the lookup's share of the technique's value
inline constexpr const char* kTrueDistance = "trueDistance";  // double, P to the scene along R, scene units
inline constexpr const char* kThrough = "through";            // double, transmittance, mean of the colours, 0..1
inline constexpr const char* kError = "error";                // double, H to the true hit, scene units
// Field arrays of strings that describe the indices in a file.
inline constexpr const char* kProbeNames = "probeNames";
inline constexpr const char* kKindNames = "kindNames";
}  // namespace ray_array

}  // namespace boxprobe
