// What the stages on rectified rows share: the per-slice record and the parameters of a prefix.
// Images are stored with slices along x and columns along y, so that neighbouring invocations, which work on neighbouring
// slices, touch neighbouring texels.
#ifndef TYNDALL_VOLUMETRICS_RECTIFIED_H
#define TYNDALL_VOLUMETRICS_RECTIFIED_H
#include "stages/blocks.h"
TY_SHARED_BEGIN

struct Slice {
  float first, last;     // columns span these distances from the axis, m; first = last: nothing can be blocked
  float nodeLow, nodeHigh;  // range of the reference coordinate (lib/epipolar.glsl) for the Chebyshev nodes
  vec3 shadowStep;       // change of shadow texel and depth per metre of distance from the axis
  float unused_;
};

struct RectifiedParams {
  int reference_ray;     // 0 bisectrix, 1 optimum, 2 mean: used when there is one reference ray
  int weights;           // 0 average, 1 transmittance
};

struct RectifiedBlock {
  RayBlock rays;
  RectifiedParams rectified;
  int overestimation;    // 0 lower, 1 half, 2 upper, 3 adaptive
  float momentBias;      // alpha_b
  float biasTarget;      // even entries of the four-moment bias vector
};

struct RectifiedSunBlock {
  SunBlock sun;
  EpipolarBlock epipolar;
};

TY_SHARED_END
#endif
