// Parameters that every technique reads, and the choice of the technique.
#ifndef TYNDALL_VOLUMETRICS_COMMON_PARAMS_H
#define TYNDALL_VOLUMETRICS_COMMON_PARAMS_H
#include "params/rows.h"

#define TY_COMMON_PARAMS(INT, FLOAT, ENUM, BOOL)                                                        \
  BOOL(enabled, "volumetrics.enabled", "Enabled", 1, 0, TY_PARAMETER_STRUCTURAL,                        \
       "Off: no scattering and no extinction, and no pass is run.")                                     \
  ENUM(technique, "volumetrics.technique", "Technique", "exact", "",                                    \
       "none|ray_march|min_max|shadow_volume|epipolar_sampling|froxel|fourier|moments4|moments6|exact", \
       TY_PARAMETER_STRUCTURAL, "How single scattering is computed; none is the same as not enabled.")  \
  ENUM(placement, "volumetrics.placement", "Placement", "pixel", "half|quarter|epipolar",               \
       "pixel|half|quarter|epipolar", TY_PARAMETER_STRUCTURAL,                                          \
       "Where rays are evaluated: one a pixel, or fewer, upsampled.")                                   \
  FLOAT(sigma_t, "medium.sigma_t", "Extinction", 0.03, 0, 10, "1/m", TY_PARAMETER_LOGARITHMIC,          \
        "Extinction coefficient of the homogeneous medium; its inverse is the mean free path.")         \
  FLOAT(albedo, "medium.albedo", "Albedo", 0.9, 0, 1, "", 0,                                            \
        "Single-scattering albedo: the share of extinguished light that is scattered.")                 \
  FLOAT(g, "medium.g", "Anisotropy g", 0.5, -0.99, 0.99, "", 0,                                         \
        "Mean cosine of the Henyey-Greenstein phase function; positive is forward: bright towards the light.")

#endif
