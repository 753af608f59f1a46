// Moments as a prefix image holds them, and visibility from them in any precision of number.
#pragma once

#include <array>
#include <cmath>
#include <ostream>

#include "lib/cpp.hpp"
#include "techniques/moments/storage.hpp"

namespace tyndall::stability {

using volumetrics::MomentStorage;
using volumetrics::Precision;

/// One way of storing moments. `paper`: the moment bias that Peters et al. 2017 give for it (sections 2.5 and 5.4.3).
struct Format {
  const char* name;
  int moments;
  Precision precision;
  double paper;
};
/// How GoogleTest names it.
inline void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }
inline constexpr std::array kFormats = {
    Format{"4x16 bit", 4, Precision::kCompact, 6e-5}, Format{"4x32 float", 4, Precision::kFull, 3e-7},
    Format{"6x10 bit", 6, Precision::kCompact, 4e-3}, Format{"6x16 bit", 6, Precision::kStandard, 8e-5},
    Format{"6x32 float", 6, Precision::kFull, 5e-6}};
inline MomentStorage storageOf(const Format& format) {
  return volumetrics::momentStorage(format.moments, format.precision);
}

/// What the images return for one texel.
struct Texel {
  glm::vec4 four{};
  glm::vec3 odd{}, even{};
};

inline float unorm(float x, int bits) {
  const float top = static_cast<float>((1 << bits) - 1);
  return std::round(std::fmin(std::fmax(x, 0.0f), 1.0f) * top) / top;
}

/// Stores moments 1 to 6 (floats, as moments_prefix.comp.glsl has them before imageStore).
inline Texel stored(const Format& format, const std::array<float, 7>& b) {
  const MomentStorage s = storageOf(format);
  Texel texel{{b[1], b[2], b[3], b[4]}, {b[1], b[3], b[5]}, {b[2], b[4], b[6]}};
  if (!s.quantise) return texel;
  const int bits = s.threeAndThree ? 10 : 16;
  texel.four = lib::f32::quantise4(texel.four);
  texel.odd = lib::f32::quantise6Odd(texel.odd);
  texel.even = lib::f32::quantise6Even(texel.even);
  for (int i = 0; i < 4; ++i) texel.four[i] = unorm(texel.four[i], bits);
  for (int i = 0; i < 3; ++i) texel.odd[i] = unorm(texel.odd[i], bits), texel.even[i] = unorm(texel.even[i], bits);
  return texel;
}

/// The linear filter between two texels, in float.
inline Texel filtered(const Texel& a, const Texel& b, float t) {
  return {a.four * (1 - t) + b.four * t, a.odd * (1 - t) + b.odd * t, a.even * (1 - t) + b.even * t};
}

/// What moments_evaluate.comp.glsl makes of a texel, in numbers of type Real.
template <class Real>
Real visibility(const Format& format, const Texel& texel, float alpha, float zf, float beta) {
  using namespace lib::f32;
  using namespace lib::f64;
  using namespace lib::f80;
  const MomentStorage s = storageOf(format);
  const Real a = alpha, z = zf, b = beta;
  if (format.moments == 4) {
    glm::vec<4, Real> four(texel.four);
    if (s.quantise) four = dequantise4(four);
    return visibility4(bias4(four, a, Real(s.evenTarget)), z, b);
  }
  glm::vec<3, Real> odd(texel.odd), even(texel.even);
  if (s.quantise) {
    odd = dequantise6Odd(odd);
    even = dequantise6Even(even);
  }
  return visibility6(bias6Odd(odd, a), bias6Even(even, a), z, b);
}

}  // namespace tyndall::stability
