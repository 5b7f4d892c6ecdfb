// What a set of projection rays says of each of its lines: kinds, status bits and the names of the cell arrays. Written
// by vtkProjectionRays, read by the layer that draws rays and by whoever opens a saved .vtp; knows no VTK.
#pragma once

#include <string_view>

namespace boxprobe {

/// Array "kind". P surface point, N normal, R reflection, C capture origin, H hit on the probe's proxy.
enum class RayKind : int {
  Eye = 0,        ///< eye to P; parallel projection: against the view direction, MaximumLength long
  Normal = 1,     ///< P along N, NormalLength long
  Reflected = 2,  ///< P to H; MaximumLength along R where there is no proxy to hit
  Lookup = 3,     ///< C to what is looked up (H - C for box projection), one a fetch
  Sample = 4,     ///< P to what a fetch looks up, of techniques that look up more or other than H
  TrueHit = 5,    ///< P along R to the scene itself
  Error = 6,      ///< H to the true hit
  Within = 7,     ///< of glass: P through it to where the light leaves, a line for each time it is mirrored
  Refracted = 8,  ///< of glass: from there to H; MaximumLength where there is no proxy to hit
  Shadow = 9,     ///< P towards a light that asks for shadows, to where it leaves the probe's box
};
inline constexpr int kRayKinds = 10;
inline constexpr std::string_view kRayKindNames[kRayKinds] = {
    "eye ray",  "normal", "reflected ray", "lookup",        "sample",
    "true hit", "error",  "within glass",  "refracted ray", "shadow ray"};

/// Array "status": 0, or the sum of what is unusual at the point or between point and probe.
enum RayStatus : int {
  kRayNoNormal = 1,        ///< normal missing, zero or not finite: only the eye ray is drawn
  kRayEyeOnPoint = 2,      ///< no direction to the eye: only the normal is drawn
  kRayFromBehind = 4,      ///< N.V <= 0: the eye is behind the surface, and R goes straight on
  kRayNoProxy = 8,         ///< the technique meets nothing (infinite, normal, projection off): no hit, no error
  kRayPointOutside = 16,   ///< P outside the projection box: H is clamped on to it
  kRayOriginOutside = 32,  ///< C outside the projection box: one direction stands for two places of it
  kRayNoProbe = 64,        ///< no probe's influence reaches P: the sky is looked up along R
};

// Cell arrays. -1 stands for what is not defined (no hit, no probe, no box): nothing is ever NaN or infinite.
namespace ray_array {
inline constexpr const char* kKind = "kind";                  // int
inline constexpr const char* kStatus = "status";              // int
inline constexpr const char* kPoint = "point";                // int, index of the input point
inline constexpr const char* kProbe = "probe";                // int, index of the probe
inline constexpr const char* kFace = "face";                  // int, 0..5: -x +x -y +y -z +z of the box
inline constexpr const char* kHitPoint = "hitPoint";          // 3 double, world; the line's end where there is no hit
inline constexpr const char* kHitDistance = "hitDistance";    // double, P to H, scene units
inline constexpr const char* kDirection = "lookupDirection";  // 3 double, probe's axes, as handed to the map, not unit
inline constexpr const char* kLevel = "level";                // double, of the prefiltered chain
inline constexpr const char* kWeight = "weight";              // double, the probe's share of the point, 0..1
inline constexpr const char* kLookupShare = "lookupShare";    // double, the fetch's share of the technique's value
inline constexpr const char* kTrueDistance = "trueDistance";  // double, P to the scene along R, scene units
inline constexpr const char* kThrough = "through";            // double, of the light, mean of its colours, 0..1
inline constexpr const char* kError = "error";                // double, H to the true hit, scene units
// Field arrays of strings, so that a file explains itself.
inline constexpr const char* kProbeNames = "probeNames";
inline constexpr const char* kKindNames = "kindNames";
}  // namespace ray_array

}  // namespace boxprobe
