// Resamples a sun's shadow map into epipolar coordinates (Peters et al. 2017, section 5.1.1; Baran et al. 2010).
// Inputs: Slice buffer; shadow map (D32 array, layer 0). Output: R16 unorm or R32F, slices x columns: inclination of the first
// blocker on the light ray through (slice, column), normalised to the frame's range; 1 where nothing blocks.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, scalar) uniform Light { RectifiedSunBlock light; };
layout(binding = 1, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 2) uniform sampler2DArray shadowMap;
layout(binding = 3) uniform writeonly image2D rectified;

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= light.epipolar.slices || at.y >= light.epipolar.columns) return;
  float first = slices[at.x].first;
  float last = slices[at.x].last;
  float column = first + (float(at.y) + 0.5) * (last - first) / float(light.epipolar.columns);
  vec3 p = light.sun.shadowEye + column * slices[at.x].shadowStep;
  float depth = 1.0;
  if (last > first && all(greaterThanEqual(p.xy, vec2(0.0))) && all(lessThan(p.xy, vec2(light.sun.shadowSize)))) {
    float stored = texelFetch(shadowMap, ivec3(ivec2(p.xy), 0), 0).x;
    if (stored < 1.0) {
      // Height above the eye's plane, towards the light, at which the light ray reaches the stored depth.
      float height = (stored - p.z) / light.epipolar.shadowAlong.z;
      depth = normalisedInclination(inclination(column, height), light.epipolar.thetaMin, light.epipolar.thetaMax);
    }
  }
  imageStore(rectified, ivec2(at), vec4(depth));
}
