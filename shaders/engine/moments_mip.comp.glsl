// One mip level of a four-moment shadow map from the level above it: each texel is the mean of the two by two above it.
// In: the finer level (linear filter: one fetch between four texels). Out: the coarser level of the same image.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray finer;
layout(binding = 1) uniform writeonly image2DArray coarser;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  ivec2 size = imageSize(coarser).xy;
  if (any(greaterThanEqual(at.xy, size))) return;
  imageStore(coarser, at, textureLod(finer, vec3((vec2(at.xy) + 0.5) / vec2(size), float(at.z)), 0.0));
}
