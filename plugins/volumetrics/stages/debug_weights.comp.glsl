// The weight of each column of a rectified map for each reference ray, relative to the mean weight of the slice's columns.
// Input: Slice buffer. Output: R32F array, slices x columns, one layer a reference ray.
// Equation: Klehm et al. 2014, equation 11.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform writeonly image2DArray weights;

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"

const int kParts = 64;  // of a row, to add up weights that have no closed integral

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= int(light.map.slices) || at.y >= int(totalColumns())) return;
  Slice s = slices[at.x];
  float key = referenceKey(s, at.z, kReferenceRays);
  float total = kLocal ? 0.0 : transmittanceIntegral(key, 0.0, s.last - s.first);
  float part = float(totalColumns()) / float(kParts);
  for (int i = 0; i < kParts && kLocal; ++i) total += referenceWeight(s, key, float(i) * part, float(i + 1) * part);
  float own = referenceWeight(s, key, float(at.y), float(at.y + 1));
  imageStore(weights, at, vec4(total > 0.0 ? own / total * float(totalColumns()) : 0.0));
}
