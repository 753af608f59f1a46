// Uniform blocks that several techniques share; C++ and GLSL, scalar layout.
#ifndef TYNDALL_VOLUMETRICS_BLOCKS_H
#define TYNDALL_VOLUMETRICS_BLOCKS_H
#include "shared/types.h"
TY_SHARED_BEGIN

// The camera as rays. The direction of a pixel is forward + x*right + y*up with x, y in [-1, 1] (y up): its length is the
// inverse cosine of the angle to the optical axis, so that distance along the ray = length * distance along the axis.
struct RayBlock {
  vec3 eye;
  vec3 forward;       // unit
  vec3 right;         // times tan of half the horizontal field of view
  vec3 up;            // times tan of half the vertical field of view
  vec2 pixelScale;    // 2/width, 2/height
  float znear, zfar;  // m
  uint frameIndex;
  float sigma_t;      // 1/m
  float albedo;
  float g;
};

// A directional light with its shadow map, as an affine map: a point eye + v has shadow texel and depth
// shadowEye + shadowX*v.x + shadowY*v.y + shadowZ*v.z (x, y in texels, z the stored depth).
struct SunBlock {
  vec3 irradiance;    // lux
  vec3 towards;       // unit, to the light
  vec3 shadowEye, shadowX, shadowY, shadowZ;
  float shadowSize;   // texels a side
};

const uint kMaxPolygon = 24u;

// The epipolar frame of one sun (see lib/epipolar.glsl). Slices: azimuth phiMin + (i + 1/2) phiStep about `towards`, measured
// from e1 towards e2.
struct EpipolarBlock {
  vec3 e1, e2;             // unit, perpendicular to the light's direction
  float phiMin, phiStep;   // rad
  float thetaMin, thetaMax;  // range of the rectified depth, rad, guard band included
  float meanTheta;         // mean of the extreme inclinations of the frustum, rad
  uint fullCircle;         // 1: slices wrap round (an epipole is on the screen)
  uint columns, slices;
  vec3 shadowAlong;        // change of shadow texel and depth per metre towards the light (x, y are 0)
  uint planeCount;         // side planes of the frustum in the basis (e1, e2, towards); inside: dot >= 0
  vec3 planes[4];
  uint polygonCount;       // half-planes dot(n, p) <= h of the region, around the axis, in which light rays can be blocked;
  vec3 polygon[kMaxPolygon];  // (n.x, n.y, h), metres; 0 half-planes: nothing can be blocked
};

TY_SHARED_END
#endif
