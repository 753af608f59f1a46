// What the stages on rectified rows share: the per-slice record and the parameters of a prefix.
// Images are stored with slices along x and columns along y, so that neighbouring invocations, which work on
// neighbouring slices, touch neighbouring texels. The maps of several splits follow each other along y.
#ifndef TYNDALL_VOLUMETRICS_RECTIFIED_H
#define TYNDALL_VOLUMETRICS_RECTIFIED_H
#include "stages/blocks.h"
TY_SHARED_BEGIN

struct Slice {
  float first, last;  // all columns together span these distances from the axis, m, or, of a spot or point light, these
                      // angles at the light, rad; first = last: nothing can be blocked, or no light gets there
  float perX;         // distance from the axis per metre along e1: the inverse cosine of the azimuth from e1
  float nodeLow, nodeHigh;  // range of the reference coordinate (stages/reference_rays.glsl) for the Chebyshev nodes
  float nearest;            // width of the first columns in even ones (lib/epipolar.glsl: columnsReach)
  float lookBack;           // columns before a ray's end that may show the very surface that ends it, whole number >= 1
  vec2 direction;           // unit, along (e1, e2)
  vec3 shadowStep;          // change of shadow texel and depth per metre of distance from the axis
};

struct RectifiedParams {
  int reference_ray;  // 0 bisectrix, 1 optimum, 2 mean: used when there is one reference ray
  int weights;        // 0 average, 1 transmittance
  int near_correction;
  int epipole_block;   // pixels
  int column_spacing;  // 0 distance, 1 transmittance: suns in the epipolar rectification
};

struct RectifiedBlock {
  RayBlock rays;
  RectifiedParams rectified;
  int overestimation;  // 0 lower, 1 half, 2 upper, 3 adaptive
  float momentBias;    // alpha_b
  float biasTarget;    // even entries of the four-moment bias vector
  int basisCount;      // Fourier functions, sines and cosines counted
};

struct RectifiedLightBlock {
  SunBlock sun;
  RectificationBlock map;
  vec4 epipoles;  // pixels (x, y) at which the directions to the light and away from it meet the screen; -1e9: nowhere
                  // near
  LocalBlock local;           // of a spot or point light; of sun.* such a light has `towards` alone
  float distance;             // of a spot or point light from the eye, m
  float thetaLow, thetaHigh;  // inclinations that the table of unshadowed integrals covers, rad
  CookieBlock cookie;
  float nearby;  // of a spot or point light: share of a march in the result, which a light near the eye is left to
  // A reference ray of a spot or point light gives no column less than these leave it: optical depth of the way, and
  // share of the range's window.
  float mostWay, leastWindow;
};

TY_SHARED_END
#endif
