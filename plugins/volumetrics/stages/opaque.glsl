// Branches on members of uniform blocks, hidden from the driver; compute shaders only.
// lavapipe (Mesa 22.3) compiles a shader anew for the values that its branches and the lengths of its loops take from a uniform block, at each
// dispatch, keeps every one of them until the process ends, and stops that only for a shader of which less than half falls away
// (update_inline_shader_state() in lvp_execute.c). What hangs on an input of the invocation is left alone, and compiled where the pipeline is made.
#ifndef TYNDALL_VOLUMETRICS_OPAQUE_GLSL
#define TYNDALL_VOLUMETRICS_OPAQUE_GLSL

// The value itself: no device has so many workgroups. The answer is the same in a workgroup, so that branches stay those of a whole wave.
bool opaque(bool value) { return value != (gl_WorkGroupID.x == 0xffffffffu); }
uint opaque(uint value) { return value + uint(gl_WorkGroupID.x == 0xffffffffu); }
int opaque(int value) { return value + int(gl_WorkGroupID.x == 0xffffffffu); }
float opaque(float value) { return value + float(gl_WorkGroupID.x == 0xffffffffu); }

#endif
