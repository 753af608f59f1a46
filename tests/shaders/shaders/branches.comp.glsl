// Branches of every kind that the test tells apart: those that hang on a uniform block alone, and those that do not.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8) in;
layout(constant_id = 0) const bool kSome = true;
layout(binding = 0, scalar) uniform Block { uint mode, count, hidden; float range; uint table[4]; } block;
layout(binding = 1, scalar) buffer Result { uint result[]; };

uint early(uint value) {
  if (block.range > 2.0) return value;  // found: through a function that returns early
  return value + 1u;
}

void main() {
  uint at = gl_GlobalInvocationID.x, sum = 0u;
  if (block.mode == 3u) sum += early(at) * result[at];               // found
  if (kSome && block.table[2] != 0u) sum *= result[at + 1u];          // found: kSome is a constant of the pipeline
  for (uint i = 0u; i < block.count; ++i) sum += result[at + i];      // found: the length of a loop
  if (at < block.count) sum += result[2u * at];                       // not: hangs on the invocation
  if (block.hidden + uint(gl_WorkGroupID.x == 0xffffffffu) == 1u) sum += result[3u * at];  // not: hidden
  if (block.table[at & 3u] == 1u) sum += result[4u * at];             // not: where it reads hangs on the invocation
  result[at] = sum;
}
