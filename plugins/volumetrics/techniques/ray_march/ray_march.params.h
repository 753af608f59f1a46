// Parameters of the ray marchers.
#ifndef TYNDALL_VOLUMETRICS_RAY_MARCH_PARAMS_H
#define TYNDALL_VOLUMETRICS_RAY_MARCH_PARAMS_H
#include "params/rows.h"

#define TY_RAY_MARCH_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                    \
  INT(steps, "volumetrics.steps", "Steps", 64, 1, 16384, 1, 16384, "", TY_PARAMETER_LOGARITHMIC,                       \
      "Visibility samples a ray and light, spread over the part of the ray that can be shadowed at all; of a spot or " \
      "point light, over the part that its cone and range reach.")                                                     \
  ENUM(jitter, "volumetrics.jitter", "Jitter", "none", "", "none|white", 0,                                            \
       "Offset of the samples inside their strata: the middle, or one random offset a pixel and frame.")               \
  ENUM(                                                                                                                \
      march_spacing, "volumetrics.march_spacing", "Spacing", "transmittance", "", "distance|transmittance", 0,         \
      "Strata of equal length, or where samples count: for a sun of equal share of the transmittance integral, for a " \
      "spot or point light of equal angle as seen from the light.")

#endif
