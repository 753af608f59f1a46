// Depth of alpha-tested shadow casters. In: positions, uv, vertex colour, instances. Out: clip position, base-colour
// uv, alpha.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/surface.h"

layout(push_constant, scalar) uniform Push { mat4 clipFromWorld; };
layout(binding = 0, scalar) readonly buffer Instances { InstanceBlock instances[]; };
layout(binding = 1, scalar) uniform Material { MaterialBlock material; };
layout(location = 0) in vec3 inPosition;
layout(location = 3) in vec2 inUv;
layout(location = 4) in vec4 inColor;

layout(location = 0) out vec3 outUvAlpha;
layout(location = 1) flat out float outCutoff;

void main() {
  UvTransform t = material.baseColorUv;
  outUvAlpha = vec3(dot(t.u, vec3(inUv, 1.0)), dot(t.v, vec3(inUv, 1.0)), material.baseColor.a * inColor.a);
  outCutoff = material.alphaCutoff;
  gl_Position = clipFromWorld * (instances[gl_InstanceIndex].worldFromObject * vec4(inPosition, 1.0));
}
