// One case for the device, the same in GLSL and C++ (scalar layout), and the routines that maths.comp.glsl knows.
#ifdef __cplusplus
#pragma once
#define CONSTANT inline constexpr int
#else
#define CONSTANT const int
#endif

struct Record {
  int routine;
  int option;  // moments: stored through the quantisation transform or not; medium: which
  float values[9];
};

CONSTANT kVisibility4 = 0;  // b1 to b4 as stored, bias, bias target, ray's depth -> lower, upper
CONSTANT kVisibility6 = 1;  // odd, even as stored, bias, ray's depth -> lower, upper
CONSTANT kTwoDepths = 2;    // b1, b2, b3 -> z1, z2, w1, w2
CONSTANT kFourier = 3;      // blocker's depth, ray's depth, functions -> sum
CONSTANT kAverage = 4;      // first value, the others, columns -> compensated, plain average of equal shares
CONSTANT kMedium = 5;       // medium_cases.hpp
#undef CONSTANT
