// Test: declares a binding that the pass's table lacks.
#version 460
layout(local_size_x = 1) in;
layout(binding = 0, std430) writeonly buffer Arguments { uint data[]; };
layout(binding = 7, std430) readonly buffer More { uint more[]; };

void main() { data[0] = more[0]; }
