// The filmic curve of ACES (reference rendering and output transform for Rec. 709 displays) as fitted by Narkowicz
// 2015, ACES
// Filmic Tone Mapping Curve; its five constants are his fit. Linear Rec. 709 in, [0, 1] out. Deviates from ACES in
// that it
// works on each channel, so that bright lights go towards white. (Khronos PBR Neutral was tried first: it takes 0.04
// off
// every colour, which swallows faint fog.)
#ifndef TYNDALL_TONEMAP_GLSL
#define TYNDALL_TONEMAP_GLSL

vec3 toneMap(vec3 x) {
  return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

#endif
