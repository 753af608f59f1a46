// Uniform block of the ray marcher.
#ifndef TYNDALL_VOLUMETRICS_RAY_MARCH_BLOCKS_H
#define TYNDALL_VOLUMETRICS_RAY_MARCH_BLOCKS_H
#include "stages/blocks.h"
#include "techniques/ray_march/ray_march.params.h"
TY_SHARED_BEGIN

// Choices of jitter and march_spacing.
const int kJitterWhite = 1;
const int kSpacingTransmittance = 1;

struct RayMarchParams {
  TY_FIELDS(TY_RAY_MARCH_PARAMS)
};
struct RayMarchBlock {
  RayBlock rays;
  RayMarchParams march;
};

TY_SHARED_END
#endif
