// Parameters of the Fourier technique alone (precision is the moments' too, and stands there).
#ifndef TYNDALL_VOLUMETRICS_FOURIER_PARAMS_H
#define TYNDALL_VOLUMETRICS_FOURIER_PARAMS_H
#include "params/rows.h"

#define TY_FOURIER_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                     \
  INT(basis_count, "volumetrics.basis_count", "Basis count", 32, 4, 128, 4, 128, "", TY_PARAMETER_STRUCTURAL,         \
      "Fourier functions, sines and cosines counted: ringing falls with their number, memory and time grow with it.") \
  INT(bases_per_thread, "volumetrics.bases_per_thread", "Bases per thread", 8, 4, 32, 4, 32, "",                      \
      TY_PARAMETER_STRUCTURAL,                                                                                        \
      "Fourier functions that one invocation filters, rounded up to a multiple of four (a texel): fewer are more "    \
      "parallel but read the rectified map more often.")                                                              \
  ENUM(basis_evaluation, "volumetrics.basis_evaluation", "Basis evaluation", "fused", "", "fused|separate",           \
       TY_PARAMETER_STRUCTURAL,                                                                                       \
       "Evaluate the basis inside the filter, or in a pass of its own that stores it (more memory traffic).")

#endif
