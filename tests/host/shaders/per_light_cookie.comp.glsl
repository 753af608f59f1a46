// Test: one light's share, plus what lies between mips 1 and 2 of the last layer of its cookie, and what the repeating
// sampler makes of that layer's left border.
#version 460
layout(local_size_x_id = 0, local_size_y_id = 0) in;
layout(binding = 0, rgba32f) uniform writeonly image2D share;
layout(binding = 1, std140) uniform Light { vec4 weighted; vec4 unused; };
layout(binding = 2) uniform sampler2DArray cookie;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(share)))) return;
  const float last = float(textureSize(cookie, 0).z - 1);
  const float value = textureLod(cookie, vec3(0.5, 0.5, last), 1.5).r + textureLod(cookie, vec3(0.0, 0.5, last), 0.0).r;
  imageStore(share, p, vec4(weighted.x + value, 0.0, 0.0, 0.0));
}
