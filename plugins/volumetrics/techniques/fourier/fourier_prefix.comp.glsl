// Prefix averages of the Fourier basis (Klehm et al. 2014, section 3.3): an invocation filters kVectors texels of four functions.
// Inputs: Slice buffer; rectified maps (stages/prefix.glsl), or the stored basis. Outputs, slices x columns: RGBA8 or RGBA16 unorm
// array, layers of one reference ray after the other; prefix bounds RG16.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/fourier.glsl"
#include "stages/rectified.h"

layout(constant_id = 0) const int kVectors = 2;        // texels a group: bases_per_thread / 4
layout(constant_id = 2) const int kLayers = 8;         // of one reference ray
layout(constant_id = 4) const bool kStoredBasis = false;
layout(binding = 6) uniform writeonly image2DArray prefix;
layout(binding = 7) uniform sampler2DArray storedBasis;

#include "stages/prefix.glsl"

void basisAt(ivec2 at, float depth, int group, out vec4 v[kVectors]) {
  int layer = group * kVectors;
  if (kStoredBasis) {
    for (int i = 0; i < kVectors; ++i)
      v[i] = texelFetch(storedBasis, ivec3(at, min(layer + i, kLayers - 1)), 0) * 2.0 - 1.0;
    return;
  }
  vec2 turn = fourierTurn(depth);
  vec2 phase = fourierStart(depth, layer);
  for (int i = 0; i < kVectors; ++i) {
    vec2 second = fourierNext(phase, turn);
    v[i] = fourierBasis(phase, second) * fourierMask(layer + i, frame.basisCount);
    phase = fourierNext(second, turn);
  }
}

void storePrefix(ivec2 at, int k, int group, vec4 v[kVectors]) {
  for (int i = 0; i < kVectors; ++i) {
    int layer = group * kVectors + i;
    if (layer < kLayers) imageStore(prefix, ivec3(at, k * kLayers + layer), v[i] * 0.5 + 0.5);
  }
}
