// Single scattering of one sun from the prefix of moments: one look-up per pixel (Peters et al. 2017, sections 5.3 and 5.4), K of
// them with reference rays, none where the prefix bounds settle the ray.
// Inputs: scene depth (D32, reversed); Slice buffer; the prefix images of moments_prefix.comp. Output: RGBA32F as in
// ray_march.comp.
// Deviations: columns cover only the part of the ray where light can be blocked (before and after it is lit, in closed form);
// neighbouring slices are interpolated each at its own column coordinate, since spans differ from slice to slice.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/moments.glsl"
#include "stages/rectified.h"
#include "stages/rays.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int kMoments = 6;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 2) const bool kQuantise = true;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 4) const bool kThreeAndThree = false;
layout(constant_id = 5) const bool kLinearRows = true;
layout(constant_id = 6) const bool kFirstLight = true;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedSunBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray momentsA;  // linear filter
layout(binding = 5) uniform sampler2DArray momentsB;
layout(binding = 6) uniform sampler2D bounds;         // nearest
layout(binding = 7, rgba32f) uniform image2D scatter;

const int kLower = 0, kHalf = 1, kUpper = 2;
const float kHalfStep = 0.5 / 65535.0;  // of 16-bit unorm

struct Row {
  int index;
  float weight;
  float first, last, nodeLow, nodeHigh;
  float column;  // coordinate in [0, columns]: the prefix covers the columns before it
};

Row row(int index, float weight, float reach) {
  Row r;
  int count = int(light.epipolar.slices);
  r.index = light.epipolar.fullCircle != 0u ? (index + count) % count : clamp(index, 0, count - 1);
  r.weight = weight;
  Slice s = slices[r.index];
  r.first = s.first;
  r.last = s.last;
  r.nodeLow = s.nodeLow;
  r.nodeHigh = s.nodeHigh;
  float span = s.last - s.first;
  r.column = span > 0.0 ? clamp((reach - s.first) / span, 0.0, 1.0) * float(light.epipolar.columns) : 0.0;
  return r;
}

// Texture coordinate at which linear filtering gives the prefix up to `column`: texel j holds the prefix of columns 0..j.
vec3 coordinate(Row r, int k) {
  return vec3((float(r.index) + 0.5) / float(light.epipolar.slices),
              max(r.column - 0.5, 0.5) / float(light.epipolar.columns), float(k));
}

float visibility(Row a, Row b, int k, float z, float beta) {
  vec3 uva = coordinate(a, k);
  vec3 uvb = coordinate(b, k);
  vec4 first = textureLod(momentsA, uva, 0.0);
  if (kLinearRows) first = first * a.weight + textureLod(momentsA, uvb, 0.0) * b.weight;
  if (kMoments == 4) {
    vec4 moments = kQuantise ? dequantise4(first) : first;
    return visibility4(bias4(moments, frame.momentBias, frame.biasTarget), z, beta);
  }
  vec4 second = textureLod(momentsB, uva, 0.0);
  if (kLinearRows) second = second * a.weight + textureLod(momentsB, uvb, 0.0) * b.weight;
  vec3 odd = first.xyz;
  vec3 even = kThreeAndThree ? second.xyz : vec3(first.w, second.xy);
  if (kQuantise) {
    odd = dequantise6Odd(odd);
    even = dequantise6Even(even);
  }
  return visibility6(bias6Odd(odd, frame.momentBias), bias6Even(even, frame.momentBias), z, beta);
}

// Mean visibility over the columns before the ray's end, weighted by transmittance.
float meanVisibility(Row a, Row b, float theta) {
  float depth = normalisedInclination(theta, light.epipolar.thetaMin, light.epipolar.thetaMax);
  if (kBounds) {
    // Whole columns only: the one in which the ray ends holds the very surface that ends it, at the ray's own inclination.
    vec2 range = texelFetch(bounds, ivec2(a.index, max(int(a.column) - 1, 0)), 0).xy;
    if (kLinearRows) {
      vec2 other = texelFetch(bounds, ivec2(b.index, max(int(b.column) - 1, 0)), 0).xy;
      range = vec2(min(range.x, other.x), max(range.y, other.y));
    }
    if (depth <= range.x - kHalfStep || range.x >= 1.0) return 1.0;
    if (depth > range.y + kHalfStep) return 0.0;
  }
  float z = 2.0 * depth - 1.0;
  float halfSine = sin(0.5 * theta);
  float beta = frame.overestimation == kLower ? 0.0
             : frame.overestimation == kHalf  ? 0.5
             : frame.overestimation == kUpper ? 1.0
                                              : halfSine * halfSine;  // section 5.3.1
  if (kReferenceRays == 1) return visibility(a, b, 0, z, beta);
  float low = mix(b.nodeLow, a.nodeLow, a.weight);
  float high = mix(b.nodeHigh, a.nodeHigh, a.weight);
  float x = clamp((2.0 * referenceCoordinate(theta) - low - high) / max(high - low, 1e-6), -1.0, 1.0);
  float sum = 0.0;
  for (int k = 0; k < kReferenceRays; ++k)
    sum += chebyshevLagrange(k, kReferenceRays, x) * visibility(a, b, k, z, beta);
  return clamp(sum, 0.0, 1.0);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  vec3 direction = rayDirection(frame.rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(frame.rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  float sigma_t = frame.rays.sigma_t;

  // Epipolar coordinates of the ray.
  vec3 local = vec3(dot(direction, light.epipolar.e1), dot(direction, light.epipolar.e2), dot(direction, light.sun.towards));
  float sine = length(local.xy);
  float theta = atan(sine, local.z);
  float phi = atan(local.y, local.x);
  float at = (phi - light.epipolar.phiMin) / light.epipolar.phiStep;
  float reach = end * sine;
  Row a, b;
  if (kLinearRows) {
    float below = floor(at - 0.5);
    float share = at - 0.5 - below;
    a = row(int(below), 1.0 - share, reach);
    b = row(int(below) + 1, share, reach);
  } else {
    a = row(int(floor(at)), 1.0, reach);
    b = a;
    b.weight = 0.0;
  }

  // Along the ray: lit up to `enter`, from the rows up to `leave`, lit to the end.
  float safeSine = max(sine, 1e-7);
  float enter = min((a.first * a.weight + b.first * b.weight) / safeSine, end);
  float leave = min((a.last * a.weight + b.last * b.weight) / safeSine, end);
  float integral = transmittanceIntegral(sigma_t, 0.0, end);
  if (leave > enter)
    integral -= transmittanceIntegral(sigma_t, enter, leave) * (1.0 - meanVisibility(a, b, theta));
  float sigma_s = frame.rays.albedo * sigma_t;
  float phase = phaseHenyeyGreenstein(local.z, frame.rays.g);
  vec3 radiance = sigma_s * phase * max(integral, 0.0) * light.sun.irradiance;
  if (kFirstLight)
    imageStore(scatter, ivec2(pixel), vec4(radiance, exp(-sigma_t * end)));
  else
    imageStore(scatter, ivec2(pixel), imageLoad(scatter, ivec2(pixel)) + vec4(radiance, 0.0));
}
