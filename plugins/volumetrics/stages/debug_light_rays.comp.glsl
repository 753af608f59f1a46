// The light ray of each texel of the maps of rows, as two points in world space (TY_VIEW_LIGHT_RAY_START and _END): through the middle of
// its slice and column, from nearer to the light than every view ray to the first blocker or, without one, to where the last view ray meets
// it. A blocker before all view rays is put where the first of them meets the light ray. And the normalised depths of its blockers, whichever rectification they come from.
// Inputs: Slice buffer; rectified maps. Output: RGBA32F array, slices x columns: layer 0 start, A 1 where there is such a ray; layer 1 end, A 1
// where it is blocked; layer 2 R G depths of two blockers, B share of the second, A 0. Equations: shaders/lib/epipolar.glsl, shaders/lib/local_row.glsl.
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
layout(constant_id = 8) const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly image2DArray lightRays;

#include "stages/rows.glsl"
#include "stages/texel_depths.glsl"

const float kLeastAngle = 1e-3;  // rad: a ray that leaves the axis by less goes on for a thousand times its distance

// The point at inclination theta of the light ray at distance (or angle at the light) c in the direction e.
vec3 pointAt(vec3 e, float c, float theta) {
  if (!kLocal) return frame.rays.eye + c * e + c / tan(theta) * light.sun.towards;
  // The triangle of eye, light and point: its angle at the point is pi - theta - c.
  float fromLight = light.distance * sin(theta) / max(sin(theta + c), 1e-6);
  return frame.rays.eye + light.local.position + fromLight * (sin(c) * e - cos(c) * light.sun.towards);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(lightRays).xy;
  if (any(greaterThanEqual(at, size))) return;
  vec4 start = vec4(0.0);
  vec4 end = vec4(0.0);
  vec3 depths = vec3(1.0, 1.0, 0.0);
  if (at.x < int(light.map.slices) && at.y < int(totalColumns()) && slices[at.x].last > slices[at.x].first) {
    Slice s = slices[at.x];
    vec3 e = s.direction.x * light.map.e1 + s.direction.y * light.map.e2;
    float c = columnDistance(s, float(at.y) + 0.5);
    depths = texelDepths(at);
    float depth = depths.x;
    float most = kLocal ? kPi - c - kLeastAngle : kPi - kLeastAngle;
    float low = clamp(light.map.depthLow, 2.0 * kLeastAngle, most);
    float theta = light.map.depthLow + pow(depth, 1.0 / light.map.depthPower) / light.map.depthScale;
    bool blocked = depth < 1.0 && theta < most;
    start = vec4(kLocal ? frame.rays.eye + light.local.position : pointAt(e, c, max(0.5 * low, kLeastAngle)), 1.0);
    end = vec4(pointAt(e, c, clamp(theta, low, most)), blocked ? 1.0 : 0.0);
  }
  imageStore(lightRays, ivec3(at, 0), start);
  imageStore(lightRays, ivec3(at, 1), end);
  imageStore(lightRays, ivec3(at, 2), vec4(depths, 0.0));
}
