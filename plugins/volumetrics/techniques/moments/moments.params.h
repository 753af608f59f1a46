// Parameters of the moment techniques alone.
#ifndef TYNDALL_VOLUMETRICS_MOMENTS_PARAMS_H
#define TYNDALL_VOLUMETRICS_MOMENTS_PARAMS_H
#include "params/rows.h"

#define TY_MOMENTS_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                      \
  ENUM(overestimation, "volumetrics.overestimation", "Overestimation", "adaptive", "", "lower|half|upper|adaptive", 0, \
       "Where between the sharp bounds the answer is taken: lower underestimates scattering; adaptive is "             \
       "sin^2(theta/2) "                                                                                               \
       "of the angle between view ray and light (no leaking when looking into the light).")                            \
  ENUM(precision, "volumetrics.precision", "Precision", "standard", "", "compact|standard|full",                       \
       TY_PARAMETER_STRUCTURAL,                                                                                        \
       "Storage of the prefix. Six moments: 6x10, 6x16 bit, 6x32-bit float. Four: 4x16 bit, then 4x32-bit float. "     \
       "Fourier: 8 bit, "                                                                                              \
       "and 16 bit for full.")

#endif
