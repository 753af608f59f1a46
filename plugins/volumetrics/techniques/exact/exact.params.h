// Parameters of the technique exact.
#ifndef TYNDALL_VOLUMETRICS_EXACT_PARAMS_H
#define TYNDALL_VOLUMETRICS_EXACT_PARAMS_H
#include "params/rows.h"

#define TY_EXACT_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                    \
  INT(levels, "volumetrics.levels", "Levels", 0, 0, 14, 0, 14, "", TY_PARAMETER_STRUCTURAL,                        \
      "Levels of the wavelet matrix that are built and walked: each halves the depths that a ray may be mistaken " \
      "about. 0, or more "                                                                                         \
      "than a row has: all, which is exact to the map.")

#endif
