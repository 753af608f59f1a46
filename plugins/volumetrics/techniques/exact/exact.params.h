// Parameters of the technique exact.
#ifndef TYNDALL_VOLUMETRICS_EXACT_PARAMS_H
#define TYNDALL_VOLUMETRICS_EXACT_PARAMS_H
#include "params/rows.h"

#define TY_EXACT_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                        \
  ENUM(                                                                                                                \
      row_order, "volumetrics.row_order", "Row order", "depth", "", "depth|column", TY_PARAMETER_STRUCTURAL,           \
      "How exact keeps a row: its columns in the order of depth, counted in blocks that the ray itself weighs, or in " \
      "their own order, as a wavelet matrix with weights for each reference ray.")                                     \
  ENUM(row_blocks, "volumetrics.row_blocks", "Row blocks", "32", "", "8|16|32|64|columns", TY_PARAMETER_STRUCTURAL,    \
       "Blocks of neighbouring columns that a row in the order of depth is counted in. columns: every column by "      \
       "itself, which is the sum over the map, slowly.")                                                               \
  INT(levels, "volumetrics.levels", "Levels", 0, 0, 14, 0, 14, "", TY_PARAMETER_STRUCTURAL,                            \
      "Levels of the wavelet matrix that are built and walked: each halves the depths that a ray may be mistaken "     \
      "about. 0, or more "                                                                                             \
      "than a row has: all, which is exact to the map.")

#endif
