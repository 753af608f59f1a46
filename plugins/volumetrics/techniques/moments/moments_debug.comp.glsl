// The moments themselves, from the combinations of them that the prefix stores. Inputs: images of moments_prefix.comp, first reference
// ray. Output: RGBA32F array of two layers, slices x columns: moments 1 to 4; 5 and 6.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/portable.h"
#include "lib/moments.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int kMoments = 6;
layout(constant_id = 2) const bool kQuantise = true;
layout(constant_id = 4) const bool kThreeAndThree = false;
layout(binding = 0) uniform sampler2DArray momentsA;
layout(binding = 1) uniform sampler2DArray momentsB;
layout(binding = 2) uniform writeonly image2DArray shown;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(shown).xy))) return;
  vec4 first = texelFetch(momentsA, ivec3(at, 0), 0);
  if (kMoments == 4) {
    imageStore(shown, ivec3(at, 0), kQuantise ? dequantise4(first) : first);
    imageStore(shown, ivec3(at, 1), vec4(0.0));
    return;
  }
  vec4 second = texelFetch(momentsB, ivec3(at, 0), 0);
  vec3 odd = first.xyz;
  vec3 even = kThreeAndThree ? second.xyz : vec3(first.w, second.xy);
  if (kQuantise) {
    odd = dequantise6Odd(odd);
    even = dequantise6Even(even);
  }
  imageStore(shown, ivec3(at, 0), vec4(odd.x, even.x, odd.y, even.y));
  imageStore(shown, ivec3(at, 1), vec4(odd.z, even.z, 0.0, 0.0));
}
