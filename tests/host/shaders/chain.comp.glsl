// Test: one mip from another of the same image, half as wide and high: the sum of its four texels; the first mip from
// nothing (FIRST), x + 100 y.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kFirst = 0u;
layout(binding = 0, r32f) uniform writeonly image2D to;
layout(binding = 1) uniform sampler2D from;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(to)))) return;
  if (kFirst != 0u) {
    imageStore(to, p, vec4(float(p.x) + 100.0 * float(p.y)));
    return;
  }
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += texelFetch(from, 2 * p + ivec2(i & 1, i >> 1), 0).r;
  imageStore(to, p, vec4(sum));
}
