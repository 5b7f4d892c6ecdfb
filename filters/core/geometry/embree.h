// The differences between Embree 3 and 4 for single rays. For the rooms that link Embree; this one does not.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>
#include <initializer_list>

#include "filters/core/base/errors.h"
#include "filters/core/base/memory_check.h"

namespace boxprobe {

/// Embree aborts the program at ray coordinates beyond this (its FLT_LARGE) and at NaN.
constexpr float kLargestRayCoordinate = 1.8e18f;

/// On x86 with the instructions of AVX2 at most, as wider ones round some hits otherwise: machines of one farm write
/// the same bytes. Throws WorkError, or std::bad_alloc.
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
