// Parameters of techniques that are not built yet: their ids and ranges are fixed already, no built technique reads them, so
// any value is kept and reported as unused.
#ifndef TYNDALL_VOLUMETRICS_RESERVED_PARAMS_H
#define TYNDALL_VOLUMETRICS_RESERVED_PARAMS_H
#include "params/rows.h"

#define TY_RESERVED_PARAMS(INT, FLOAT, ENUM, BOOL)                                                                       \
  INT(levels, "volumetrics.levels", "Levels", 0, 0, 12, 0, 12, "", 0,                                                    \
      "Levels that a query of the technique exact walks; 0 = all.")

#endif
