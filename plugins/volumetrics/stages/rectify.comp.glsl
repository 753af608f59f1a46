// Resamples a sun's shadow map into epipolar coordinates (Peters et al. 2017, section 5.1.1; Baran et al. 2010).
// Inputs: Slice buffer; shadow map (D32 array, layer 0) or, for filtered resampling (section 5.2, algorithm 2), the four-moment
// shadow map. Output, slices x columns: normalised depth of the first blocker on the light ray through (slice, column), 1 where
// nothing blocks: R16 unorm or R32F; filtered: RGBA16 unorm or RGBA32F, the depths of two blockers and the second's share.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/moments.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool kFiltered = false;
layout(constant_id = 1) const bool kQuantisedMoments = true;  // of the moment shadow map
layout(binding = 0, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 1, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 2) uniform sampler2DArray shadowMap;   // depth, nearest; or moments, linear and mipmapped
layout(binding = 3) uniform writeonly image2DArray rectified;

#include "stages/rows.glsl"

// The empty background (depth 1) is placed this exactly by moments of 16 bit, and by those of 32.
const float kEmpty = kQuantisedMoments ? 1.0 - 2e-3 : 1.0 - 1e-5;

// Samples of the moment shadow map for one texel, at most.
const float kMostSamples = 8.0;
// Variance in square texels of the host's Gaussian, and of one texel of a mip with its bilinear filter per square of its size: a box of
// width w has w^2 / 12, so mips are for footprints wider than kLeastWidth = sqrt(12 (kGaussianVariance + kMipVariance)).
const float kGaussianVariance = 2.25;
const float kMipVariance = 0.25;
const float kLeastWidth = 5.5;

// Normalised depth at distance c from the axis of a blocker at a stored depth; `p` is the light ray's foot in the map.
float blockerDepth(float c, vec3 p, float stored) {
  // Height above the eye's plane, towards the light, at which the light ray reaches the stored depth.
  return rectifiedDepth(c, (stored - p.z) / light.map.shadowAlong.z);
}

// Mean of the stored moments over a texel's footprint, whose sides are `along` and `across` in shadow texels: samples along the longer
// side, each from the mip whose filter spreads as far as the sample's share of the footprint.
vec4 sampleMoments(vec2 at, vec2 along, vec2 across) {
  bool longerAlong = length(along) > length(across);
  vec2 line = longerAlong ? along : across;
  float shorter = length(longerAlong ? across : along);
  float samples = clamp(ceil(length(line) / max(shorter, kLeastWidth)), 1.0, kMostSamples);
  float width = max(shorter, length(line) / samples);
  float lod = 0.5 * log2(max(width * width / (12.0 * kMipVariance) - kGaussianVariance / kMipVariance, 1.0));
  vec4 sum = vec4(0.0);
  for (float i = 0.5; i < samples; i += 1.0)
    sum += textureLod(shadowMap, vec3((at + line * (i / samples - 0.5)) / light.sun.shadowSize, 0.0), lod);
  return sum / samples;
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= light.map.slices || at.y >= light.map.columns) return;
  Slice s = slices[at.x];
  float c = columnDistance(s, float(at.y) + 0.5);
  vec3 p = light.sun.shadowEye + c * s.shadowStep;
  vec4 result = vec4(1.0, 1.0, 0.0, 0.0);
  bool inside = all(greaterThanEqual(p.xy, vec2(0.0))) && all(lessThan(p.xy, vec2(light.sun.shadowSize)));
  if (s.last > s.first && inside) {
    if (kFiltered) {
      // Footprint in shadow texels of one column and of one slice.
      vec2 along = s.shadowStep.xy * (columnDistance(s, float(at.y) + 1.0) - columnDistance(s, float(at.y)));
      vec2 turn = c * (sliceDirection(float(at.x) + 1.0) - sliceDirection(float(at.x)));
      vec3 world = turn.x * light.map.e1 + turn.y * light.map.e2;
      vec2 across = light.sun.shadowX.xy * world.x + light.sun.shadowY.xy * world.y + light.sun.shadowZ.xy * world.z;
      vec4 b = sampleMoments(p.xy, along, across);
      if (kQuantisedMoments) b = dequantise4(b);
      vec4 two = twoDepths(b);  // z1, z2, w1, w2: depths in [-1, 1], 1 where nothing was drawn
      vec2 stored = clamp(two.xy * 0.5 + 0.5, 0.0, 1.0);
      float first = stored.x < kEmpty ? blockerDepth(c, p, stored.x) : 1.0;
      float second = stored.y < kEmpty ? blockerDepth(c, p, stored.y) : 1.0;
      result = vec4(first, second, two.w, 0.0);
    } else {
      float stored = texelFetch(shadowMap, ivec3(ivec2(p.xy), 0), 0).x;
      if (stored < 1.0) result.x = blockerDepth(c, p, stored);
    }
  }
  imageStore(rectified, ivec3(at, 0), result);
}
