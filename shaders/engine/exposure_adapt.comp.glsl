// The exposure that a picture asks for, from its histograms, and the way there.
// In: counts of exposure_meter.comp, which are 0 again afterwards. In and out: what was metered last (MeteredBlock); a copy of it goes to
// a buffer that the host reads. One workgroup.
// Equation: target = key / 2^mean, the mean of log2 luminance over the samples between two percentiles (lib/exposure.glsl).
// A picture without light keeps the factor that it has.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"

#include "lib/exposure.glsl"
#include "shared/exposure.h"

layout(local_size_x = 256) in;
layout(push_constant, scalar) uniform Push { MeterPush push; };
layout(binding = 0, scalar) buffer Counts { ExposureCounts counts; };
layout(binding = 1, scalar) buffer Metered { MeteredBlock metered; };
layout(binding = 2, scalar) writeonly buffer Copy { MeteredBlock copied; };

const uint kBins = kToneBins + kDistanceBins;
shared uint bins[kBins];

void main() {
  uint lane = gl_LocalInvocationIndex;
  // 1. All counts at once, which leaves them at 0 for the next picture.
  for (uint i = lane; i < kToneBins; i += 256u) {
    bins[i] = counts.tones[i];
    counts.tones[i] = 0u;
  }
  for (uint i = lane; i < kDistanceBins; i += 256u) {
    bins[kToneBins + i] = counts.distances[i];
    counts.distances[i] = 0u;
  }
  barrier();
  if (lane != 0u) return;

  // 2. Mean of the tones between the trims.
  float total = 0.0;
  for (uint i = 0u; i < kToneBins; ++i) total += float(bins[i]);
  float before = 0.0, sum = 0.0, weight = 0.0;
  for (uint i = 0u; i < kToneBins; ++i) {
    float share = toneShare(before, float(bins[i]), total);
    sum += share * toneOfBin(int(i));
    weight += share;
    before += float(bins[i]);
  }
  MeteredBlock now = metered;
  if (weight > 0.0) now.logTarget = toneTarget(sum / weight);
  now.logFactor = toneAdapted(now.logFactor, now.logTarget, push.seconds);

  // 3. Median distance of the surfaces, their mean transmittance.
  now.samples = counts.samples;
  now.surfaces = counts.surfaces;
  now.transmittance = float(counts.transmittance) / 16384.0 / max(float(counts.surfaces), 1.0);
  now.distance = 0.0;
  uint nearer = 0u;
  for (uint i = 0u; i < kDistanceBins && 2u * nearer < now.surfaces; ++i) {
    nearer += bins[kToneBins + i];
    if (2u * nearer >= now.surfaces) now.distance = distanceOfBin(int(i));
  }
  counts.samples = 0u;
  counts.surfaces = 0u;
  counts.transmittance = 0u;
  metered = now;
  copied = now;
}
