// Test: copies a texel; "clear" draws it over, "add" blends it.
#version 460
layout(binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 color;

void main() {
  const vec4 texel = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
  color = vec4(texel.r, 0.0, 0.0, 0.0);
}
