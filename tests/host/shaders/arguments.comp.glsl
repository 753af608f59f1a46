// Test: writes the counts of the indirect dispatch: 5 x 2 x 1 groups at byte 4.
#version 460
layout(local_size_x = 1) in;
layout(binding = 0, std430) writeonly buffer Arguments { uint data[]; };
layout(binding = 1, std140) uniform Frame { float reset; };

void main() {
  data[0] = 77u + uint(reset);
  data[1] = 5u;
  data[2] = 2u;
  data[3] = 1u;
}
