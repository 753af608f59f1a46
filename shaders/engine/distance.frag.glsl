// Distance along each pixel's ray from the eye to the surface or the far plane.
// In: depth (D32, reversed: 1 at znear, 0 at zfar or where nothing was drawn). Out: R32F, metres.
// Equation: depth = (n/(f-n) (f - z)) / z for a point at z metres along the optical axis, so z = n f / (n + depth (f -
// n));
// the ray is longer by 1/cos of its angle to the axis.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(push_constant, scalar) uniform Push {
  vec2 tangent;   // of half the field of view, horizontally and vertically
  vec2 size;      // pixels
  float znear, zfar;
};
layout(binding = 0) uniform sampler2D depthTarget;
layout(location = 0) out float outDistance;

void main() {
  float depth = texelFetch(depthTarget, ivec2(gl_FragCoord.xy), 0).r;
  vec2 slope = (gl_FragCoord.xy / size * 2.0 - 1.0) * tangent;
  outDistance = znear * zfar / (znear + depth * (zfar - znear)) * sqrt(1.0 + dot(slope, slope));
}
