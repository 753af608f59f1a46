// Uniform blocks that several techniques share; C++ and GLSL, scalar layout.
#ifndef TYNDALL_VOLUMETRICS_BLOCKS_H
#define TYNDALL_VOLUMETRICS_BLOCKS_H
#include "shared/lamp.h"
#include "shared/types.h"
TY_SHARED_BEGIN

// The camera as rays. The direction of a pixel is forward + x*right + y*up with x, y in [-1, 1] (y up): its length is
// the inverse cosine of the angle to the optical axis, so that distance along the ray = length * distance along the
// axis.
struct RayBlock {
  vec3 eye;
  vec3 forward;       // unit
  vec3 right;         // times tan of half the horizontal field of view
  vec3 up;            // times tan of half the vertical field of view
  vec2 pixelScale;    // 2/width, 2/height
  float znear, zfar;  // m
  uint frameIndex;
  float sigma_t;  // 1/m
  float albedo;
  float g;
};

// A directional light with its shadow map, as an affine map: a point eye + v has shadow texel and depth
// shadowEye + shadowX*v.x + shadowY*v.y + shadowZ*v.z (x, y in texels, z the stored depth).
struct SunBlock {
  vec3 irradiance;  // lux
  vec3 towards;     // unit, to the light
  vec3 shadowEye, shadowX, shadowY, shadowZ;
  float shadowSize;  // texels a side
};

// Numbers of TyLightKind that shaders tell apart.
const uint kLocalSpot = 1u;
const uint kLocalPoint = 2u;

// A spot or point light with its shadow map (KHR_lights_punctual). Face i of the map (+X -X +Y -Y +Z -Z of a point
// light, else 0) shows a point at `w` from the light, m along the face's axis, at (dot(faceX[i], w), dot(faceY[i], w))
// / m in [-1, 1] and at depth depthScale - depthOffset / m: the projection's matrix without what is the same or zero in
// every face, as a matrix chosen by a variable costs sixteen loads a sample.
struct LocalBlock {
  vec3 position;               // of the light minus the eye, world axes, m
  vec3 intensity;              // cd
  vec3 axis;                   // spot: unit, the way the light travels
  float range;                 // m; 0: unlimited
  float cosOuter, sinOuter;    // spot: of the outer cone's half angle
  float coneOuter, coneScale;  // ConeFalloff (shared/lamp.h); 1 and 1 for a point light
  uint kind;                   // kLocal...
  float shadowSize;            // texels a side
  float texelAngle;            // angle of the map's smallest texel as the light sees it, rad
  float depthScale, depthOffset;
  vec3 faceX[6], faceY[6];
};

// The image that a light shines through (TyLight.cookie_from_world), for points relative to the eye.
struct CookieBlock {
  mat4 fromEye;
  uint faces;    // 0: no cookie, 1, or 6 of a point light
  uint repeats;  // bit 0 along x, bit 1 along y
};

const uint kMaxPolygon = 24u;
const uint kMaxBorderEdges = 5u;
const uint kMaxSplits = 4u;
const uint kMaxSegments = 32u;  // eight regions of four splits

// How the index of a slice follows from a direction's components (x, y) along e1 and e2.
const int kSlicesByAzimuth = 0;  // uniform in atan(y, x)
const int kSlicesByBorder =
    1;  // uniform along the border of the screen (Baran et al. 2010; Klehm et al. 2014, section 4.1)
const int kSlicesByTangent =
    2;  // uniform in y/x: the projective (linear) rectification (Klehm et al. 2014, section 4.2)

// One straight part of the screen's border, seen along the light: from `start` to `start + delta`, azimuth growing.
struct BorderEdge {
  vec2 start, delta;
  float phiStart, phiEnd;        // rad
  float sliceStart, sliceCount;  // in slices
};

// How view rays become rows (see lib/epipolar.glsl). Epipolar: a column is a distance from the axis, spread per slice
// over [first, last] of its Slice; depth is the inclination. Projective: columns are uniform in 1/x, x the distance
// along e1; stored is the height over x (the cotangent of the inclination, over the cosine of the azimuth), which is
// turned into the inclination when read.
struct RectificationBlock {
  vec3 e1, e2;                   // unit, perpendicular to the light's direction
  int slicing;                   // kSlicesBy...
  float sliceLow, sliceStep;     // azimuth (rad) or tangent of slice coordinate 0, and its change per slice
  float depthLow, depthScale;    // normalised depth = (inclination - depthLow) * depthScale, guard band included
  float rasterLow, rasterScale;  // projective: a stored depth is (minus height over x - rasterLow) * rasterScale
  float depthPower;              // warp: the normalised depth is raised to this power; 1 is none
  float meanTheta;               // mean of the extreme inclinations of the frustum, rad
  uint fullCircle;               // 1: slices wrap round (an epipole is on the screen)
  uint columns, slices;          // of one map
  uint splits;                   // maps one behind the other; more than one with the projective rectification only
  uint segmentCount;             // parts of the columns of all maps that are prefixed each on its own ("regions")
  uint segmentStart[kMaxSegments + 1u];  // their first columns, rising, and the end of the last
  uint segmentsByDistance;  // 1: an epipolar map in place of projective ones; its parts begin where theirs do, at these
                            // distances
  float segmentDistance[kMaxSegments + 1u];  // along e1, m, and each slice has its own columns there
  float share;       // of the light that this map answers for: 1, but where one map fades into another
  uint nearLit;      // 1: what lies before the first column is known to be lit; 0: it is not in the map
  float inverse[5];  // projective: 1/x at the borders of the splits, 1/m, falling
  vec3 shadowAlong;  // change of shadow texel and depth per metre towards the light (x, y are 0)
  float reach;       // greatest distance from the axis at which light can be blocked, m
  uint planeCount;   // side planes of the frustum in the basis (e1, e2, towards); inside: dot >= 0
  vec3 planes[4];
  uint polygonCount;  // half-planes dot(n, p) <= h of the region, around the axis, in which light rays can be blocked;
  vec3 polygon[kMaxPolygon];  // (n.x, n.y, h), metres; 0 half-planes: nothing can be blocked
  uint edgeCount;
  BorderEdge edges[kMaxBorderEdges];
};

TY_SHARED_END
#endif
