// Purpose: places the triangles of the user interface.
// In: Dear ImGui's vertices (position in points, texture coordinates, sRGB-coded colour) -> out: the same, in clip space.
#version 460

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;

layout(push_constant) uniform Push {
  vec2 scale;   // clip units per point
  vec2 offset;  // clip coordinates of point (0, 0)
} push;

layout(location = 0) out vec2 outUv;
layout(location = 1) out vec4 outColor;

void main() {
  outUv = uv;
  outColor = color;
  gl_Position = vec4(position * push.scale + push.offset, 0.0, 1.0);
}
