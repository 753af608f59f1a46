// Purpose: shows that the build compiles shaders as the running program does. -> squares (float, linear). No deviation.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "built_square.glsl"
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kCount = 64;
layout(binding = 0, scalar) buffer Values { float values[]; };
void main() {
  if (gl_GlobalInvocationID.x < kCount) values[gl_GlobalInvocationID.x] = square(values[gl_GlobalInvocationID.x]);
}
