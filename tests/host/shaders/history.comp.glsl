// Test: counts frames in an image and in a buffer that are kept.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) uniform image2D frames;
layout(binding = 1, std430) buffer Kept { uint count; };

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(frames)))) return;
  imageStore(frames, p, imageLoad(frames, p) + 1.0);
  if (p == ivec2(0)) ++count;
}
