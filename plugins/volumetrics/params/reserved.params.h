// Parameters of techniques that are not built yet: their ids and ranges are fixed already, no built technique reads them, so
// any value is kept and reported as unused.
#ifndef TYNDALL_VOLUMETRICS_RESERVED_PARAMS_H
#define TYNDALL_VOLUMETRICS_RESERVED_PARAMS_H
#include "params/rows.h"

#define TY_RESERVED_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                       \
  INT(basis_count, "volumetrics.basis_count", "Basis count", 32, 4, 128, 4, 128, "", 0,                                  \
      "Fourier coefficients, sines and cosines counted (technique fourier).")                                            \
  INT(bases_per_thread, "volumetrics.bases_per_thread", "Bases per thread", 8, 4, 32, 4, 32, "", 0,                      \
      "Fourier coefficients that one invocation filters (technique fourier).")                                           \
  ENUM(basis_evaluation, "volumetrics.basis_evaluation", "Basis evaluation", 0, 0, "fused|separate", 0,                  \
       "Evaluate the basis inside the filter or before it (technique fourier).")                                         \
  INT(regions, "volumetrics.regions", "Regions", 1, 1, 8, 1, 8, "", 0,                                                   \
      "Parts into which a row is split for the prefix.")                                                                 \
  INT(splits, "volumetrics.splits", "Splits", 1, 1, 4, 1, 4, "", 0, "Maps of the linear rectification.")                 \
  INT(levels, "volumetrics.levels", "Levels", 0, 0, 12, 0, 12, "", 0,                                                    \
      "Levels that a query of the technique exact walks; 0 = all.")

#endif
