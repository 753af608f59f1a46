// Makes occluders of a sky map one texel wider on each side, so that no wall lets light through between its texels.
// In: D32 depths, 0 nearest the sky. Out: R32F, the least of each texel and its eight neighbours.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray depths;
layout(binding = 1, r32f) uniform writeonly image2DArray spread;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last = imageSize(spread).xy - 1;
  if (any(greaterThan(at, last))) return;
  float least = 1.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      least = min(least, texelFetch(depths, ivec3(clamp(at + ivec2(x, y), ivec2(0), last), 0), 0).r);
  imageStore(spread, ivec3(at, 0), vec4(least));
}
