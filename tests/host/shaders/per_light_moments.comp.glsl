// Test: one light's share, plus what lies between mips 1 and 2 of the first layer of its moment shadow map.
#version 460
layout(local_size_x_id = 0, local_size_y_id = 0) in;
layout(binding = 0, rgba32f) uniform writeonly image2D share;
layout(binding = 1, std140) uniform Light { vec4 weighted; vec4 unused; };
layout(binding = 2) uniform sampler2DArray moments;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(share)))) return;
  imageStore(share, p, vec4(weighted.x + textureLod(moments, vec3(0.5, 0.5, 0.0), 1.5).b, 0.0, 0.0, 0.0));
}
