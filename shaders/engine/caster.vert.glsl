// Depth of opaque shadow casters. In: positions, instances. Out: clip position by the push constant's matrix alone.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/surface.h"

layout(push_constant, scalar) uniform Push { mat4 clipFromWorld; };
layout(binding = 0, scalar) readonly buffer Instances { InstanceBlock instances[]; };
layout(location = 0) in vec3 inPosition;

void main() { gl_Position = clipFromWorld * (instances[gl_InstanceIndex].worldFromObject * vec4(inPosition, 1.0)); }
