// Where the end of each pixel's view ray lies in the maps of rows (TY_VIEW_ROW_PLACE): R slice and G column coordinate over the map's
// size, B inclination, rad, A normalised depth.
// Inputs: scene depth; Slice buffer; the resampled map, for its size. Output: RGBA32F.
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
const int kRowFilter = 0;
const bool kFirstLight = true;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 6) uniform sampler2DArray rectified;
layout(binding = 21) uniform sampler2DArray unshadowed;

#define TY_OWN_MAIN
#include "stages/rays_on_rows.glsl"

vec3 meanVisibility(RowRay ray) { return vec3(1.0); }

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  vec3 direction = rayDirection(frame.rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(frame.rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  vec3 local = vec3(dot(direction, light.map.e1), dot(direction, light.map.e2), dot(direction, light.sun.towards));
  RowRay ray = rowRay(local, end, false);
  // Slices wrap round where an epipole is on the screen; the maps of further lights are smaller than the image.
  float slice = opaque(light.map.fullCircle) != 0u ? mod(ray.slice, float(light.map.slices)) : clamp(ray.slice, 0.0, float(light.map.slices));
  vec2 size = vec2(textureSize(rectified, 0).xy);
  imageStore(scatter, ivec2(pixel), vec4(slice / size.x, ray.a.column / size.y, ray.theta, ray.depth));
}
