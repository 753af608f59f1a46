// Purpose: colours the triangles of the user interface.
// In: font atlas or picture (RGBA8 unorm, sRGB-coded) -> out: window image (8-bit unorm, sRGB-coded), blended by alpha.
// Everything is already sRGB-coded, and blending in that space is what Dear ImGui's colours are made for: no conversion.
#version 460

layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(set = 0, binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 outColor;

void main() { outColor = color * textureLod(source, uv, 0.0); }
