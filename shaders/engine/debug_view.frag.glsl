// Shows one image instead of the picture, scaled to it.
// In: any 2D view. Out: RGBA8 unorm. Values from low to high become black to white; RGB is sRGB-coded, grey is not.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "engine/include/encode.glsl"
#include "engine/include/opaque.glsl"

layout(push_constant, scalar) uniform Push {
  vec2 size;      // of the picture, pixels
  uint channel;   // 0..3: R G B A as grey; 4: RGB; 5: an octahedral normal
  float low, high;
};
layout(binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 outPicture;

void main() {
  ivec2 extent = textureSize(source, 0);
  ivec2 texel = min(ivec2(gl_FragCoord.xy / size * vec2(extent)), extent - 1);
  vec4 value = texelFetch(source, texel, 0);
  vec4 scaled = (value - low) / (high - low);
  vec3 color;
  uint shown = opaque(channel);
  if (shown < 4u) color = vec3(clamp(scaled[channel], 0.0, 1.0));
  else if (shown == 4u) color = srgbFromLinear(clamp(scaled.rgb, 0.0, 1.0));
  else color = unitFromOct(value.xy) * 0.5 + 0.5;
  outPicture = vec4(color, 1.0);
}
