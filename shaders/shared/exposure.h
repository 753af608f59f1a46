// What the engine measures of a picture: the exposure that suits it, and how much of its surfaces the air lets through.
#ifndef TYNDALL_SHARED_EXPOSURE_H
#define TYNDALL_SHARED_EXPOSURE_H
#include "shared/types.h"
TY_SHARED_BEGIN

#ifdef __cplusplus
inline constexpr uint kToneBins = 512, kDistanceBins = 192;
#else
const uint kToneBins = 512, kDistanceBins = 192;
#endif

// Pixels by log2 luminance and by distance (lib/exposure.glsl), and their sums.
struct ExposureCounts {
  uint tones[kToneBins];
  uint distances[kDistanceBins];
  uint samples, surfaces;
  uint transmittance;  // sum of 2^14 times each surface's: at most 2^17 samples are looked at
};

struct MeteredBlock {
  float logFactor;      // log2 of the linear factor in use
  float logTarget;      // log2 of the factor that this picture asks for; logFactor moves there
  uint samples;         // pixels looked at
  uint surfaces;        // of these, pixels that show a surface
  float transmittance;  // mean over those
  float distance;       // their median along the ray, m; 0 without any
};

// A sample of `stride` x `stride` pixels. What exposure_meter.comp and exposure_adapt.comp are pushed.
struct MeterPush {
  vec2 tangent;  // of half the field of view, horizontally and vertically
  uvec2 size;    // pixels of the picture
  float znear, zfar;
  uint stride;
  float seconds;  // since the factor was last adapted
};

TY_SHARED_END
#endif
