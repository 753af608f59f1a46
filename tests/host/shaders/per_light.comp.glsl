// Test: one light's share, plus 1000 times the depth at the centre of its shadow map's first layer.
#version 460
layout(local_size_x_id = 0, local_size_y_id = 0) in;
layout(binding = 0, rgba32f) uniform writeonly image2D share;
layout(binding = 1, std140) uniform Light { vec4 weighted; vec4 unused; };
layout(binding = 2) uniform sampler2DArray shadowMap;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(share)))) return;
  const float depth = textureLod(shadowMap, vec3(0.5, 0.5, 0.0), 0.0).r;
  imageStore(share, p, vec4(weighted.x + 1000.0 * depth, 0.0, 0.0, 0.0));
}
