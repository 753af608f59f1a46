// Rows in the order of depth. The columns of a row, parted into blocks of neighbours, are sorted by the depth of their first blocker. Those that
// hide a ray are the first `p` of that order, and what is asked of them is how many lie in each block, and which columns of one block they are.
// A record stands for 32 neighbours in the order: how many before it lie in each block, and the bits of their own block numbers, a word a bit
// (a "plane"). Inside a block each column keeps the rank of its depth among the block's own, in planes as well: rank < count is then a column
// that hides the ray, for 32 columns at once. Words as by wavelet matrices with bit planes (Moroto and Umetani 2022, "Constant time median filter
// using 2D wavelet matrix"); blocks weighted along the ray itself are ours.

// The lowest n bits, n in [0, 32].
LIB uint lowBits(int n) { return n >= 32 ? 0xffffffffu : (1u << uint(n)) - 1u; }

// The elements of a plane whose bit equals the lowest bit of `bit`.
LIB uint planeWhere(uint plane, uint bit) { return plane ^ ((bit & 1u) - 1u); }

// One plane of the comparison "value < count" for 32 values at once, from the highest bit down. x: those found less; y: those equal so far.
// Begin with x = 0, y = all.
LIB uvec2 planeLess(uvec2 state, uint plane, uint bit) {
  return (bit & 1u) != 0u ? uvec2(state.x | (state.y & ~plane), state.y & plane) : uvec2(state.x, state.y & ~plane);
}

// The border between bins of a normalised depth that is nearest to a ray's: columns in bins before it hide the ray. Range [0, 2^binBits].
LIB int depthBorder(Real depth, int binBits) {
  Real bins = Real(1 << binBits);
  return int(clamp(depth * bins + R(0.5), R(0.0), bins));
}

// log2 of the columns of a block, for a row of `columns`: as few as make at most 2^blockBits blocks.
LIB int blockShift(int columns, int blockBits) {
  int shift = 0;
  while ((columns - 1) >> (shift + blockBits) > 0) ++shift;
  return shift;
}

// Integral of the transmittance over a block of length `length_`, m, and optical depth x >= 0, relative to that at its start; `left` is exp(-x),
// `perSigma` one over sigma_t, m, where that is above 0. Without cancellation where x is small: next term x^3/24.
LIB Real blockIntegral(Real length_, Real x, Real left, Real perSigma) {
  return x < R(0.02) ? length_ * (R(1.0) - x * (R(0.5) - x * R(1.0 / 6.0))) : (R(1.0) - left) * perSigma;
}
