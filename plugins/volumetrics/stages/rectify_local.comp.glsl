// Resamples the shadow map of a spot or point light into the epipolar frame of stages/rectified.h: columns are angles at the light.
// Inputs: Slice buffer; shadow map (D32 array: one layer, or six faces). Output, slices x columns: normalised depth of the first blocker on the
// light ray through (slice, column), 1 where nothing blocks: R16 unorm or R32F.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 1, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 2) uniform sampler2DArray shadowMap;
layout(binding = 3) uniform writeonly image2DArray rectified;

#include "stages/rows.glsl"
#include "stages/light_rays.glsl"
#include "stages/march_cookie.glsl"
#include "stages/march_local.glsl"

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= light.map.slices || at.y >= light.map.columns) return;
  Slice s = slices[at.x];
  float result = 1.0;
  if (s.last > s.first) {
    float psi = columnDistance(s, float(at.y) + 0.5);
    vec3 away = lightRay(s.direction, psi);
    bool spot = opaque(light.local.kind) == kLocalSpot;
    uint face = localFace(light.local, away);
    vec3 m = abs(away);
    float along = spot ? dot(away, light.local.axis) : max(m.x, max(m.y, m.z));
    vec2 place = vec2(dot(light.local.faceX[face], away), dot(light.local.faceY[face], away)) / max(along, 1e-9);
    if (along > 0.0 && (!spot || all(lessThanEqual(abs(place), vec2(1.0))))) {
      ivec2 texel = clamp(ivec2((place * 0.5 + 0.5) * light.local.shadowSize), ivec2(0), ivec2(light.local.shadowSize) - 1);
      float stored = texelFetch(shadowMap, ivec3(texel, face), 0).x;
      if (stored < 1.0) {
        // Where on the light ray, m, the map's depth depthScale - depthOffset/(r along) is the stored one.
        float r = light.local.depthOffset / (max(light.local.depthScale - stored, 1e-9) * along);
        result = rectifiedDepth(r * sin(psi), light.distance - r * cos(psi));
      }
    }
  }
  imageStore(rectified, ivec3(at, 0), vec4(result));
}
