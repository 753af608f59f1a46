// Test: the output from everything else.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) uniform writeonly image2D result;
layout(binding = 1) uniform sampler2D allLights;
layout(binding = 2) uniform sampler2D frames;
layout(binding = 3) uniform sampler2DArray layers;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(result)))) return;
  imageStore(result, p, vec4(texelFetch(allLights, p, 0).r, texelFetch(frames, p, 0).r, texelFetch(layers, ivec3(p, 1), 1).r, 0.5));
}
