// Parameters of every technique that works on rectified rows.
#ifndef TYNDALL_VOLUMETRICS_RECTIFIED_PARAMS_H
#define TYNDALL_VOLUMETRICS_RECTIFIED_PARAMS_H
#include "params/rows.h"

#define TY_RECTIFIED_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                    \
  ENUM(rectification, "volumetrics.rectification", "Rectification", "epipolar", "", "auto|linear|epipolar",            \
       TY_PARAMETER_STRUCTURAL,                                                                                        \
       "How the shadow map is turned so that view rays are rows: linear is one projective matrix, rasterised "         \
       "straight into; "                                                                                               \
       "epipolar resamples the shadow map; auto takes linear where its columns and slices are even enough and the "    \
       "light is off the "                                                                                             \
       "screen, and on the way there, some six degrees of a turn, fades one map into the other, for the time of "      \
       "both. Where no projective map exists (the light or its antipode in view), or is near to degenerate, linear "   \
       "fades into epipolar and says so.")                                                                             \
  INT(splits, "volumetrics.splits", "Splits", 1, 1, 4, 1, 4, "maps", TY_PARAMETER_STRUCTURAL,                          \
      "Maps of growing size that the linear rectification is split into, each of columns x slices texels. An "         \
      "epipolar map that stands "                                                                                      \
      "in for them has the columns of all.")                                                                           \
  FLOAT(depth_warp, "volumetrics.depth_warp", "Depth warp", 0, 0, 1, "", 0,                                            \
        "Stretches the rectified depth towards the light, where epipolar depth has little precision: the normalised "  \
        "depth is raised to 1/(1 + warp).")                                                                            \
  INT(columns, "volumetrics.columns", "Columns", 1024, 64, 4096, 64, 4096, "texels", TY_PARAMETER_STRUCTURAL,          \
      "Samples along a slice of the rectified map; of further lights at most so many, by their share of the screen.")  \
  ENUM(column_spacing, "volumetrics.column_spacing", "Column spacing", "transmittance", "", "distance|transmittance",  \
       0,                                                                                                              \
       "Columns of an epipolar map of a sun: even across the light, or narrower near the eye, where a column "         \
       "scatters more of the light.")                                                                                  \
  INT(slices, "volumetrics.slices", "Slices", 1024, 64, 4096, 64, 4096, "texels", TY_PARAMETER_STRUCTURAL,             \
      "Epipolar slices of the rectified map; of further lights at most so many, by their share of the screen.")        \
  ENUM(slice_spacing, "volumetrics.slice_spacing", "Slice spacing", "azimuth", "", "azimuth|border",                   \
       TY_PARAMETER_STRUCTURAL, "Slices uniform in azimuth, or spaced evenly along the border of the screen.")         \
  INT(reference_rays, "volumetrics.reference_rays", "Reference rays", 3, 1, 6, 1, 6, "", TY_PARAMETER_STRUCTURAL,      \
      "Inclinations a slice for which the weighted prefix is kept; results are interpolated between them. 1 is the "   \
      "papers'.")                                                                                                      \
  ENUM(reference_ray, "volumetrics.reference_ray", "Reference ray", "optimum", "", "bisectrix|optimum|mean", 0,        \
       "Which ray stands for its slice when reference_rays is 1: the bisectrix of the slice, the geometric mean of "   \
       "its "                                                                                                          \
       "extreme path lengths, or the frame's mean inclination (Peters).")                                              \
  ENUM(weights, "volumetrics.weights", "Weights", "transmittance", "", "average|transmittance", 0,                     \
       "Weight of a column in the prefix: equal, or by the transmittance along the reference ray.")                    \
  BOOL(prefix_bounds, "volumetrics.prefix_bounds", "Prefix bounds", 1, 0, TY_PARAMETER_STRUCTURAL,                     \
       "Keep the prefix minimum and maximum of the rectified depth: fully lit and fully shadowed rays are then "       \
       "settled by one "                                                                                               \
       "look-up, without ringing or leaking. The last columns, which may hold the surface that ends the ray, do not "  \
       "count.")                                                                                                       \
  INT(regions, "volumetrics.regions", "Regions", 1, 1, 8, 1, 8, "", TY_PARAMETER_STRUCTURAL,                           \
      "Parts into which the columns of a map are split for the prefix: more parallel, one look-up more per region "    \
      "passed, "                                                                                                       \
      "and joined with the ray's own weights.")                                                                        \
  ENUM(prefix_scheme, "volumetrics.prefix_scheme", "Prefix scheme", "auto", "", "auto|row|block|scan",                 \
       TY_PARAMETER_STRUCTURAL,                                                                                        \
       "One invocation a slice, 8x8 blocks (Peters, appendix C; of exact: eight nodes a slice), or a workgroup scan; " \
       "auto measures which is fastest.")                                                                              \
  ENUM(row_filter, "volumetrics.row_filter", "Row filter", "linear", "", "nearest|linear|mipmapped",                   \
       TY_PARAMETER_STRUCTURAL,                                                                                        \
       "Interpolation between slices when the prefix is read; mipmapped also averages up to eight slices that share "  \
       "a pixel, by mips as "                                                                                          \
       "far as they blur no more than a 512th of the columns, by taps beyond. min_max and exact, which look for "      \
       "depths, take it as linear.")                                                                                   \
  BOOL(filtered_resampling, "volumetrics.filtered_resampling", "Filtered resampling", 0, 0, TY_PARAMETER_STRUCTURAL,   \
       "Resample from a filtered moment shadow map instead of single shadow-map texels (suns without a cookie).")      \
  INT(epipole_block, "volumetrics.epipole_block", "Epipole block", 0, 0, 64, 0, 64, "pixels", 0,                       \
      "Radius of the block around the light on screen (and its antipode) in which rays are marched densely.")          \
  BOOL(near_correction, "volumetrics.near_correction", "Near correction", 0, 0, 0,                                     \
       "Klehm's section 3.1, linear rectification: scattering before the camera's near plane, which the map does not " \
       "hold, is taken "                                                                                               \
       "off, instead of being as visible as the eye.")                                                                 \
  BOOL(reuse, "volumetrics.reuse", "Reuse", 0, 0x2, 0, "Keep what has not changed since the last frame.")

#endif
