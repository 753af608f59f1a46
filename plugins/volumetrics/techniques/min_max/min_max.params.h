// The min-max technique has no parameter of its own: it reads the rows' parameters.
#ifndef TYNDALL_VOLUMETRICS_MIN_MAX_PARAMS_H
#define TYNDALL_VOLUMETRICS_MIN_MAX_PARAMS_H
#endif
