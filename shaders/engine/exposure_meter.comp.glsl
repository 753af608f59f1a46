// Histograms of a picture: log2 luminance of what the tone map will be given, and distance of surfaces; how much of them is seen.
// In: radiance (RGBA32F), scatter (RGBA32F: RGB in-scattered radiance, A transmittance), depth (D32, reversed). One invocation looks at one
// pixel of `stride` x `stride`. In and out: counts (uint), to which is added.
// Pixels without light, and what is not a number, count in no tone bin: black borders say nothing of the rest.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"

#include "lib/exposure.glsl"
#include "shared/exposure.h"

layout(constant_id = 0) const bool HAS_SCATTER = false;
layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push { MeterPush push; };
layout(binding = 0) uniform sampler2D colorTarget;
layout(binding = 1) uniform sampler2D scatterTarget;
layout(binding = 2) uniform sampler2D depthTarget;
layout(binding = 3, scalar) buffer Counts { ExposureCounts counts; };

const uint kBins = kToneBins + kDistanceBins;
shared uint bins[kBins];
shared uint sums[3];

void main() {
  uint lane = gl_LocalInvocationIndex;
  // 1. The group's own counts begin at 0.
  for (uint i = lane; i < kBins; i += 256u) bins[i] = 0u;
  if (lane < 3u) sums[lane] = 0u;
  barrier();

  // 2. One pixel.
  uvec2 at = gl_GlobalInvocationID.xy * push.stride + push.stride / 2u;
  if (all(lessThan(at, push.size))) {
    vec3 color = texelFetch(colorTarget, ivec2(at), 0).rgb;
    float seen = 1.0;
    if (HAS_SCATTER) {
      vec4 scatter = texelFetch(scatterTarget, ivec2(at), 0);
      seen = scatter.a;
      color = color * scatter.a + scatter.rgb;
    }
    float luminance = toneLuminance(color);
    atomicAdd(sums[0], 1u);
    if (luminance > exp2(kToneLow)) atomicAdd(bins[toneBin(luminance, int(kToneBins))], 1u);
    float depth = texelFetch(depthTarget, ivec2(at), 0).r;
    if (depth > 0.0) {
      vec2 slope = ((vec2(at) + 0.5) / vec2(push.size) * 2.0 - 1.0) * push.tangent;
      float along = push.znear * push.zfar / (push.znear + depth * (push.zfar - push.znear));
      atomicAdd(bins[kToneBins + uint(distanceBin(along * sqrt(1.0 + dot(slope, slope)), int(kDistanceBins)))], 1u);
      atomicAdd(sums[1], 1u);
      atomicAdd(sums[2], uint(clamp(seen, 0.0, 1.0) * 16384.0));
    }
  }
  barrier();

  // 3. The group's counts go to the picture's.
  for (uint i = lane; i < kToneBins; i += 256u)
    if (bins[i] != 0u) atomicAdd(counts.tones[i], bins[i]);
  for (uint i = lane; i < kDistanceBins; i += 256u)
    if (bins[kToneBins + i] != 0u) atomicAdd(counts.distances[i], bins[kToneBins + i]);
  if (lane == 0u) {
    atomicAdd(counts.samples, sums[0]);
    atomicAdd(counts.surfaces, sums[1]);
    atomicAdd(counts.transmittance, sums[2]);
  }
}
