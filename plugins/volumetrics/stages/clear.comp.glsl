// Start of the result where suns are added up one by one, or where there is none: scatter 0 and the transmittance to the surface.
// Input: scene depth (D32, reversed). Output: RGBA32F.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "stages/blocks.h"
#include "stages/rays.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, scalar) uniform Frame { RayBlock rays; };
layout(binding = 1) uniform sampler2D sceneDepth;
layout(binding = 2, rgba32f) uniform writeonly image2D scatter;

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  float end = length(rayDirection(rays, pixel)) * axialDistance(rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  imageStore(scatter, ivec2(pixel), vec4(0.0, 0.0, 0.0, exp(-rays.sigma_t * end)));
}
