// Automatic exposure from a histogram of log2 luminance: which bin, which part of a bin counts, how the eye adapts. Luminance in
// the picture's linear unit (Rec. 709 primaries, after the medium, before the tone map). Include lib/portable.h first. No include guard
// on purpose: C++ includes this text once for each precision.
// Trimmed means of a log histogram: Hoffman 2006 (Crafting Physically Motivated Shading Models), Narkowicz 2016 (Automatic
// Exposure); the exponential is that of Pattanaik et al. 2000, "Time-Dependent Visual Adaptation", with one rate.

// Bins a stop, and the first one's luminance, log2: 512 bins reach from 2^-40 (a moonless night is 2^-20) to 2^40.
const Real kToneBinsPerStop = R(6.4);
const Real kToneLow = R(-40.0);
// Shares of the samples below and above which none counts: black corners, and lamps and the sun's disc.
const Real kToneTrimLow = R(0.1);
const Real kToneTrimHigh = R(0.95);
// What the mean becomes: a grey card under a clear sky, 18 % (Reinhard et al. 2002, "Photographic Tone Reproduction", equation 2).
const Real kToneKey = R(0.18);

LIB Real toneLuminance(Real3 color) { return dot(color, Real3(R(0.2126), R(0.7152), R(0.0722))); }

// Which of `count` bins has a luminance above 0; what is beyond the ends counts in them.
LIB int toneBin(Real luminance, int count) {
  return int(clamp((log2(luminance) - kToneLow) * kToneBinsPerStop, R(0.0), Real(count - 1)));
}
// log2 luminance of a bin's middle.
LIB Real toneOfBin(int bin) { return kToneLow + (Real(bin) + R(0.5)) / kToneBinsPerStop; }

// How many of a bin's `count` samples lie between the trims, if `before` samples lie in darker bins and `total` in all.
LIB Real toneShare(Real before, Real count, Real total) {
  return max(R(0.0), min(before + count, total * kToneTrimHigh) - max(before, total * kToneTrimLow));
}

// log2 of the factor that makes the mean (log2) the key.
LIB Real toneTarget(Real mean) { return log2(kToneKey) - mean; }

// log2 factor after `seconds` on the way from `now` to `target`, half of which is done in 0.35 s.
LIB Real toneAdapted(Real now, Real target, Real seconds) {
  return target + (now - target) * exp2(-seconds / R(0.35));
}

// Distances of surfaces in bins of a sixth of an octave, from 2^-8 m on.
const Real kDistanceBinsPerOctave = R(6.0);
const Real kDistanceLow = R(-8.0);
LIB int distanceBin(Real metres, int count) {
  return int(clamp((log2(metres) - kDistanceLow) * kDistanceBinsPerOctave, R(0.0), Real(count - 1)));
}
LIB Real distanceOfBin(int bin) { return exp2(kDistanceLow + (Real(bin) + R(0.5)) / kDistanceBinsPerOctave); }
