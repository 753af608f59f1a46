// Absolute difference of the technique's result and the dense march. Inputs: both, RGBA32F radiance. Output: RGBA32F, A is 1.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D result;
layout(binding = 1) uniform sampler2D dense;
layout(binding = 2) uniform writeonly image2D difference;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(difference)))) return;
  vec3 apart = texelFetch(result, at, 0).rgb - texelFetch(dense, at, 0).rgb;
  imageStore(difference, at, vec4(abs(apart), 1.0));
}
