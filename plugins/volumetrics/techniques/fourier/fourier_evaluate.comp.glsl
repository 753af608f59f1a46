// Single scattering of one light from the prefix of the Fourier basis: a dot product a look-up (Klehm et al. 2014, equations 8 to 10,
// listing 4). Inputs: scene depth (D32, reversed); Slice buffer; prefix of fourier_prefix.comp; shadow map (epipole block). Output:
// RGBA32F as in ray_march.comp. The steps around it: stages/rays_on_rows.glsl and stages/prefix_lookup.glsl.
// Deviation: the result is clamped to [0, 1].
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/fourier.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 2) const int kLayers = 8;  // of one reference ray
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 5) const int kRowFilter = 1;
layout(constant_id = 6) const bool kFirstLight = true;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 21) uniform sampler2DArray unshadowed;
layout(binding = 22) uniform sampler2DArray lit;
layout(binding = 6) uniform sampler2D bounds;         // nearest
layout(binding = 7) uniform sampler2DArray prefix;    // linear filter

#define TY_ROW_COOKIES
#include "stages/rays_on_rows.glsl"
#include "stages/prefix_lookup.glsl"

void visibilities(Place place, RowRay ray, out float v[kReferenceRays]) {
  for (int k = 0; k < kReferenceRays; ++k) v[k] = 0.5;
  vec2 turn = fourierTurn(ray.depth);
  vec2 phase = fourierStart(ray.depth, 0);
  for (int layer = 0; layer < kLayers; ++layer) {
    vec2 second = fourierNext(phase, turn);
    vec4 a = fourierCoefficients(phase, second, layer) * fourierMask(layer, frame.basisCount);
    phase = fourierNext(second, turn);
    for (int k = 0; k < kReferenceRays; ++k)
      v[k] += dot(a, lookUp(prefix, place, float(k * kLayers + layer)) * 2.0 - 1.0);
  }
}
