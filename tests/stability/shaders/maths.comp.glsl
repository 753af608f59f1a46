// The routines of shaders/lib on the device, one record an invocation. Inputs: records. Output: vec4 a record.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/moments.glsl"
#include "lib/fourier.glsl"
#include "lib/average.glsl"
#include "record.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer In { Record records[]; };
layout(binding = 1, scalar) writeonly buffer Out { vec4 results[]; };

vec4 bounds4(Record r) {
  vec4 b = vec4(r.values[0], r.values[1], r.values[2], r.values[3]);
  if (r.option != 0) b = dequantise4(b);
  b = bias4(b, r.values[4], r.values[5]);
  return vec4(visibility4(b, r.values[6], 0.0), visibility4(b, r.values[6], 1.0), 0.0, 0.0);
}

vec4 bounds6(Record r) {
  vec3 odd = vec3(r.values[0], r.values[1], r.values[2]);
  vec3 even = vec3(r.values[3], r.values[4], r.values[5]);
  if (r.option != 0) {
    odd = dequantise6Odd(odd);
    even = dequantise6Even(even);
  }
  odd = bias6Odd(odd, r.values[6]);
  even = bias6Even(even, r.values[6]);
  return vec4(visibility6(odd, even, r.values[7], 0.0), visibility6(odd, even, r.values[7], 1.0), 0.0, 0.0);
}

vec4 fourier(Record r) {
  int count = int(r.values[2]);
  vec2 turns[2] = vec2[2](fourierTurn(r.values[0]), fourierTurn(r.values[1]));
  vec2 phases[2] = vec2[2](fourierStart(r.values[0], 0), fourierStart(r.values[1], 0));
  float sum = 0.5;
  for (int layer = 0; 4 * layer < count; ++layer) {
    vec2 next[2] = vec2[2](fourierNext(phases[0], turns[0]), fourierNext(phases[1], turns[1]));
    sum += dot(fourierBasis(phases[0], next[0]) * fourierMask(layer, count), fourierCoefficients(phases[1], next[1], layer));
    for (int i = 0; i < 2; ++i) phases[i] = fourierNext(next[i], turns[i]);
  }
  return vec4(sum, 0.0, 0.0, 0.0);
}

vec4 averages(Record r) {
  vec4 kept = vec4(0.0), rest = vec4(0.0), plain = vec4(0.0);
  for (int column = 0; column < int(r.values[2]); ++column) {
    vec4 next = vec4(column == 0 ? r.values[0] : r.values[1]);
    float share = 1.0 / float(column + 1);
    vec4 step = (next - kept) * share + rest;
    rest = lostInSum(kept, step);
    kept += step;
    plain += (next - plain) * share;
  }
  return vec4(kept.x, plain.x, 0.0, 0.0);
}

vec4 medium(Record r) {
  float a = r.values[0], b = r.values[1], c = r.values[2], d = r.values[3];
  switch (r.option) {
    case 0: return vec4(oneMinusExp(a), 0.0, 0.0, 0.0);
    case 1: return vec4(transmittanceIntegral(a, b, c), 0.0, 0.0, 0.0);
    case 2: return vec4(distanceAtTransmittanceShare(a, b, c), 0.0, 0.0, 0.0);
    case 3: return vec4(runningWeight(a, b), 0.0, 0.0, 0.0);
    case 4: return vec4(phaseHenyeyGreenstein(a, b), 0.0, 0.0, 0.0);
    case 5: return vec4(inclination(a, b), 0.0, 0.0, 0.0);
    case 6: return vec4(normalisedInclination(a, b, c), 0.0, 0.0, 0.0);
    case 7: {
      float sum = 0.0;
      for (int k = 0; k < int(a); ++k) sum += chebyshevLagrange(k, int(a), b);
      return vec4(sum, 0.0, 0.0, 0.0);
    }
    case 8: return vec4(clipToHalfPlane(vec2(a, b), c, d), 0.0, 0.0);
    default: return vec4(clipToFrustumPlane(vec2(c, d), a, b), 0.0, 0.0);
  }
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Record r = records[i];
  vec4 result;
  switch (r.routine) {
    case kVisibility4: result = bounds4(r); break;
    case kVisibility6: result = bounds6(r); break;
    case kTwoDepths: result = twoDepths(vec4(r.values[0], r.values[1], r.values[2], 0.0)); break;
    case kFourier: result = fourier(r); break;
    case kAverage: result = averages(r); break;
    default: result = medium(r);
  }
  results[i] = result;
}
