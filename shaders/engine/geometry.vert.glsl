// Geometry for the G-buffer and the transparent pass.
// In: vertices (object space), instances. Out: world position, normal, tangent, uv, vertex colour.
// The normal goes with the cofactors of the transform, which is right for any scale and never divides by it.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/surface.h"
#include "shared/view.h"

layout(binding = 0, scalar) uniform ViewUniform { ViewBlock view; };
layout(binding = 1, scalar) readonly buffer Instances { InstanceBlock instances[]; };

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec2 inUv;
layout(location = 4) in vec4 inColor;

layout(location = 0) out vec3 outPosition;
layout(location = 1) out vec3 outNormal;
layout(location = 2) out vec4 outTangent;
layout(location = 3) out vec2 outUv;
layout(location = 4) out vec4 outColor;
layout(location = 5) flat out uint outMirrored;

void main() {
  vec4 world = instances[gl_InstanceIndex].worldFromObject * vec4(inPosition, 1.0);
  outPosition = world.xyz;
  mat3 normalFromObject = mat3(instances[gl_InstanceIndex].normalX, instances[gl_InstanceIndex].normalY,
                               instances[gl_InstanceIndex].normalZ);
  outNormal = normalFromObject * inNormal;
  outTangent = vec4(mat3(instances[gl_InstanceIndex].worldFromObject) * inTangent.xyz, inTangent.w);
  outUv = inUv;
  outColor = inColor;
  outMirrored = instances[gl_InstanceIndex].mirrored;
  gl_Position = view.clipFromWorld * world;
}
