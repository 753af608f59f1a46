// Alpha test of shadow casters. The image is sampled at full resolution, bilinear, exactly as in gbuffer.frag (see
// include/material.glsl): a mipmapped alpha would make shadows of distant leaves thicker or thinner than the leaves.
#version 460

layout(binding = 2) uniform sampler2D alphaMap;  // mip 0 only, bilinear
layout(location = 0) in vec3 inUvAlpha;          // base-colour uv; alpha of factor and vertex colour
layout(location = 1) flat in float inCutoff;

void main() {
  if (textureLod(alphaMap, inUvAlpha.xy, 0.0).a * inUvAlpha.z < inCutoff) discard;
}
