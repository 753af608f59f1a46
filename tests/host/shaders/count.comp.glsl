// Test: run indirectly; counts its groups and stores 0.25 + their number so far nowhere but in mip 1 of layer 1.
#version 460
layout(local_size_x = 1) in;
layout(binding = 0, r32f) uniform writeonly image2DArray part;
layout(binding = 1, std430) buffer Counted { uint groups, twice; };

void main() {
  atomicAdd(groups, 1u);
  atomicAdd(twice, 2u);
  if (gl_WorkGroupID.x + gl_WorkGroupID.y > 0u) return;
  const ivec2 size = imageSize(part).xy;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) imageStore(part, ivec3(x, y, 0), vec4(0.25 + float(x) + 100.0 * float(y)));
}
