// Branches on members of uniform blocks, hidden from the driver.
// lavapipe (Mesa 22.3) compiles a shader of some size anew for the values that its branches take from a uniform block, in every draw after a
// block was bound, keeps each until the process ends, and goes on as long as code falls away (update_inline_shader_state() in lvp_execute.c):
// megabytes and milliseconds a frame. A condition that hangs on an input of the invocation is left alone.
#ifndef TYNDALL_OPAQUE_GLSL
#define TYNDALL_OPAQUE_GLSL

// The value itself; fragment shaders only: gl_FragCoord.w is above 0 wherever something is drawn.
uint opaque(uint value) { return value + uint(gl_FragCoord.w < 0.0); }
float opaque(float value) { return value + float(gl_FragCoord.w < 0.0); }

#endif
