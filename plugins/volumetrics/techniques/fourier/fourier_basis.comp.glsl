// The Fourier basis of every texel of a rectified map, as textures (Klehm et al. 2014, section 3.3): basis_evaluation=separate, and the
// debug views of the basis. Inputs: rectified maps. Output: RGBA8 or RGBA16 unorm array, slices x columns, four functions a layer,
// mapped from [-1, 1] to [0, 1].
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

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 8) const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 6) uniform writeonly image2DArray basis;

#include "stages/rows.glsl"
#include "stages/texel_depths.glsl"

vec4 functionsAt(float depth, int layer) {
  vec2 phase = fourierStart(depth, layer);
  return fourierBasis(phase, fourierNext(phase, fourierTurn(depth)));
}

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= int(light.map.slices) || at.y >= int(totalColumns())) return;
  vec3 depths = texelDepths(at.xy);
  vec4 value = functionsAt(depths.x, at.z);
  if (kFiltered) value = mix(value, functionsAt(depths.y, at.z), depths.z);
  value *= fourierMask(at.z, frame.basisCount);
  imageStore(basis, at, value * 0.5 + 0.5);
}
