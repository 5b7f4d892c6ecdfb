// Embree 3 or 4: what differs between them for a single ray. For the rooms that link Embree; this one does not.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace boxprobe {

inline void intersectOne(RTCScene scene, RTCRayHit* query) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, query);
#endif
}

}  // namespace boxprobe
