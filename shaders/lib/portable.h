// Lets one text be GLSL and C++. The files of this folder use only these names:
//   Real, Real2, Real3, Real4  numbers and vectors;   R(0.5)  a literal;   LIB  before each function.
// GLSL: Real is float. C++ (tests): include this file, then, inside a namespace, define Real... and include the maths;
// once with float and once with double shows what rounding alone costs (shaders/lib/cpp.hpp does it).
#ifndef TYNDALL_LIB_PORTABLE_H
#define TYNDALL_LIB_PORTABLE_H
#ifndef __cplusplus
#define Real float
#define Real2 vec2
#define Real3 vec3
#define Real4 vec4
#define R(literal) literal
#define LIB
#endif
#endif
