// Depth of a shadow map, linear along its axis.
#ifndef TYNDALL_LINEAR_DEPTH_GLSL
#define TYNDALL_LINEAR_DEPTH_GLSL

// `depth` as stored, 0 at the near plane n and 1 at the far plane f; `curve` is f/n - 1, or 0 for an orthographic map, whose depth is
// linear already. A perspective map stores d = f (v - n) / (v (f - n)) for a distance v along the axis; the result is
// (v - n) / (f - n). Moments of it bound what lies far from the light as well as what lies near; those of d, most of which is
// within a percent of 1, would not.
float linearDepth(float depth, float curve) { return depth / (1.0 + (1.0 - depth) * curve); }

#endif
