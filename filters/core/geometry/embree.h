// The differences between Embree 3 and 4 for single rays. For the rooms that link Embree; this one does not.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <new>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/memory_check.h"

namespace boxprobe {

/// Embree aborts the program at ray coordinates beyond this (its FLT_LARGE) and at NaN.
constexpr float kLargestRayCoordinate = 1.8e18f;

/// On x86 with the instructions of AVX2 at most, as wider ones round some hits otherwise. Machines may still
/// differ in the last bit. Throws WorkError, or std::bad_alloc.
inline RTCDevice newRayDevice() {
#if defined(__x86_64__) || defined(_M_X64)
  const RTCDevice device = rtcNewDevice("max_isa=avx2");
#else
  const RTCDevice device = rtcNewDevice(nullptr);
#endif
  if (device == nullptr) {
    requireMemory();
    throw WorkError("the ray tracer (Embree) does not start on this machine");
  }
  return device;
}

/// After a scene was committed: throws std::bad_alloc, or WorkError that Embree cannot take `what`.
inline void checkCommitted(RTCDevice device, const std::string& what) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE) {
    throw WorkError("the ray tracer (Embree) cannot take " + what + ", error " + std::to_string(error));
  }
}

/// Space for triangles in a geometry; null pointers without memory, which the device's error tells.
struct TracedTriangles {
  glm::vec3* positions = nullptr;
  std::uint32_t* corners = nullptr;  ///< three of each triangle
};

inline TracedTriangles newTriangles(RTCGeometry geometry, std::size_t positions, std::size_t triangles) {
  return {static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                          sizeof(glm::vec3), positions)),
          static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                              3 * sizeof(std::uint32_t), triangles))};
}

/// Takes triangles without area, which no ray can hit, out of what Embree tries: a ray through a point where 600,000
/// of them lie would try each. Embree leaves out a triangle with a corner beyond the positions.
inline void leaveOutWithoutArea(const TracedTriangles& all, std::size_t triangles) {
  constexpr std::uint32_t kNoCorner = ~0u;
  for (std::size_t i = 0; i < triangles; ++i) {
    std::uint32_t* corner = all.corners + 3 * i;
    const glm::dvec3 a(all.positions[corner[0]]), b(all.positions[corner[1]]), c(all.positions[corner[2]]);
    if (glm::cross(b - a, c - a) == glm::dvec3(0.0)) corner[0] = corner[1] = corner[2] = kNoCorner;
  }
}

/// Triangles of one object, not committed yet.
inline RTCGeometry newTriangleGeometry(RTCDevice device, const std::vector<glm::vec3>& positions,
                                       const std::vector<std::uint32_t>& corners) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t triangles = corners.size() / 3;
  const TracedTriangles space = newTriangles(geometry, positions.size(), triangles);
  if (space.positions != nullptr && space.corners != nullptr) {
    std::memcpy(space.positions, positions.data(), positions.size() * sizeof(glm::vec3));
    std::memcpy(space.corners, corners.data(), 3 * triangles * sizeof(std::uint32_t));
    leaveOutWithoutArea(space, triangles);
  }
  return geometry;
}

inline bool canBeTraced(const RTCRay& ray) {
  for (const float x : {ray.org_x, ray.org_y, ray.org_z, ray.dir_x, ray.dir_y, ray.dir_z}) {
    if (!(std::fabs(x) <= kLargestRayCoordinate)) return false;
  }
  return true;
}

/// Intersects one ray. A ray that cannot be traced meets nothing.
inline void intersectOne(RTCScene scene, RTCRayHit* query) {
  if (!canBeTraced(query->ray)) return;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, query);
#endif
}

/// Does the ray meet anything up to its tfar?
inline bool occludedOne(RTCScene scene, RTCRay* ray) {
  if (!canBeTraced(*ray)) return false;
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, ray);
#endif
  return ray->tfar < 0.0f;
}

}  // namespace boxprobe
