// Purpose: single scattering of one sun in a homogeneous medium, without shadows.
// Inputs: scene depth (D32, reversed: 0 at the far plane); output: RGBA32F, RGB in-scattered radiance, A transmittance.
// Equation: along a ray of length s the sun's irradiance E is the same everywhere, so
//   L = sigma_s p E * integral_0^s exp(-sigma_t t) dt = (albedo p E) (1 - exp(-sigma_t s)),   T = exp(-sigma_t s).
// (Max 1995, Optical models for direct volume rendering, equation 5, with a constant source term.)
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x_id = 0, local_size_y_id = 1) in;

layout(binding = 0) uniform sampler2D sceneDepth;
layout(binding = 1, rgba32f) uniform writeonly image2D result;
// struct Uniforms in fog_depth.c, byte for byte.
layout(binding = 2, scalar) uniform Uniforms {
  mat4 viewFromClip;
  vec3 source;    // albedo * p * E, colour times lux over steradian
  float sigma_t;  // 1/m
};

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
  if (any(greaterThanEqual(pixel, size))) return;
  const float depth = texelFetch(sceneDepth, pixel, 0).r;
  const vec2 clip = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  const vec4 view = viewFromClip * vec4(clip, depth, 1.0);
  const float s = length(view.xyz / view.w);  // metres from the eye to the surface
  const float transmittance = exp(-sigma_t * s);
  imageStore(result, pixel, vec4(source * (1.0 - transmittance), transmittance));
}
