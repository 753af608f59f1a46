// The maths of shaders/lib compiled as C++ through GLM, in three precisions: tyndall::lib::f32, f64 and f80.
// For tests and for the CPU side of plugins; the text is the very one that the shaders include.
#pragma once

#include <glm/glm.hpp>

#define R(literal) Real(literal##L)
#define LIB inline

namespace tyndall::lib {
using namespace glm;

#define TYNDALL_LIB_PRECISION(NAME, TYPE) \
  namespace NAME {                        \
  using Real = TYPE;                      \
  using Real2 = glm::vec<2, TYPE>;        \
  using Real3 = glm::vec<3, TYPE>;        \
  using Real4 = glm::vec<4, TYPE>;        \
  }
TYNDALL_LIB_PRECISION(f32, float)
TYNDALL_LIB_PRECISION(f64, double)
TYNDALL_LIB_PRECISION(f80, long double)
#undef TYNDALL_LIB_PRECISION

// Later files use what earlier ones define.
// clang-format off
namespace f32 {
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/moments.glsl"
#include "lib/fourier.glsl"
#include "lib/average.glsl"
#include "lib/wavelet.glsl"
#include "lib/depth_order.glsl"
#include "lib/local_light.glsl"
#include "lib/cube_map.glsl"
#include "lib/exposure.glsl"
}  // namespace f32
namespace f64 {
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/moments.glsl"
#include "lib/fourier.glsl"
#include "lib/average.glsl"
#include "lib/wavelet.glsl"
#include "lib/depth_order.glsl"
#include "lib/local_light.glsl"
#include "lib/cube_map.glsl"
#include "lib/exposure.glsl"
}  // namespace f64
namespace f80 {
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/moments.glsl"
#include "lib/fourier.glsl"
#include "lib/average.glsl"
#include "lib/wavelet.glsl"
#include "lib/depth_order.glsl"
#include "lib/local_light.glsl"
#include "lib/cube_map.glsl"
#include "lib/exposure.glsl"
}  // namespace f80
// clang-format on
}  // namespace tyndall::lib

#undef R
#undef LIB
