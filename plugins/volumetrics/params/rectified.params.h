// Parameters of every technique that works on rectified rows.
#ifndef TYNDALL_VOLUMETRICS_RECTIFIED_PARAMS_H
#define TYNDALL_VOLUMETRICS_RECTIFIED_PARAMS_H
#include "params/rows.h"

#define TY_RECTIFIED_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                      \
  ENUM(rectification, "volumetrics.rectification", "Rectification", 2, 0x3, "auto|linear|epipolar",                      \
       TY_PARAMETER_STRUCTURAL,                                                                                          \
       "How the shadow map is turned so that view rays are rows: one projective matrix, or resampling in epipolar "      \
       "coordinates.")                                                                                                   \
  INT(columns, "volumetrics.columns", "Columns", 1024, 64, 4096, 64, 4096, "texels", TY_PARAMETER_STRUCTURAL,            \
      "Samples along a slice of the rectified map.")                                                                     \
  INT(slices, "volumetrics.slices", "Slices", 1024, 64, 4096, 64, 4096, "texels", TY_PARAMETER_STRUCTURAL,               \
      "Epipolar slices of the rectified map.")                                                                           \
  ENUM(slice_spacing, "volumetrics.slice_spacing", "Slice spacing", 0, 0x2, "azimuth|border", TY_PARAMETER_STRUCTURAL,   \
       "Slices uniform in azimuth, or spaced evenly along the border of the screen.")                                    \
  INT(reference_rays, "volumetrics.reference_rays", "Reference rays", 3, 1, 6, 1, 6, "", TY_PARAMETER_STRUCTURAL,        \
      "Inclinations a slice for which the weighted prefix is kept; results are interpolated between them. 1 is the "     \
      "papers'.")                                                                                                        \
  ENUM(reference_ray, "volumetrics.reference_ray", "Reference ray", 1, 0, "bisectrix|optimum|mean", 0,                   \
       "Which ray stands for its slice when reference_rays is 1: the bisectrix of the slice, the geometric mean of its " \
       "extreme path lengths, or the frame's mean inclination (Peters).")                                                \
  ENUM(weights, "volumetrics.weights", "Weights", 1, 0, "average|transmittance", 0,                                      \
       "Weight of a column in the prefix: equal, or by the transmittance along the reference ray.")                      \
  BOOL(prefix_bounds, "volumetrics.prefix_bounds", "Prefix bounds", 1, 0, TY_PARAMETER_STRUCTURAL,                       \
       "Keep the prefix minimum and maximum of the rectified depth: fully lit and fully shadowed rays are then exact "   \
       "and need no reconstruction.")                                                                                    \
  ENUM(prefix_scheme, "volumetrics.prefix_scheme", "Prefix scheme", 0, 0x8, "auto|row|block|scan",                       \
       TY_PARAMETER_STRUCTURAL,                                                                                          \
       "One invocation a slice, 8x8 blocks (Peters, appendix C), or a workgroup scan; auto measures which is fastest.")  \
  ENUM(row_filter, "volumetrics.row_filter", "Row filter", 1, 0x4, "nearest|linear|mipmapped", TY_PARAMETER_STRUCTURAL,  \
       "Interpolation between slices when the prefix is read.")                                                          \
  BOOL(filtered_resampling, "volumetrics.filtered_resampling", "Filtered resampling", 0, 0x2, TY_PARAMETER_STRUCTURAL,   \
       "Resample from a filtered moment shadow map instead of single shadow-map texels.")                                \
  INT(epipole_block, "volumetrics.epipole_block", "Epipole block", 0, 0, 64, 0, 0, "pixels", 0,                          \
      "Radius around the epipole within which rays are marched.")                                                        \
  BOOL(near_correction, "volumetrics.near_correction", "Near correction", 0, 0x2, 0,                                     \
       "Klehm's correction for the part of a ray before the near plane (linear rectification).")                         \
  BOOL(reuse, "volumetrics.reuse", "Reuse", 0, 0x2, 0, "Keep what has not changed since the last frame.")

#endif
