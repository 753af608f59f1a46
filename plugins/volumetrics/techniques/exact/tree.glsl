// What the wavelet matrix of a row is made of. A row of 1 << kBits elements (columns, padded) is stored level by level; the texel at
// position p of a level holds, of the elements of p's node up to and with p: R, how many have a rank whose next bit is 0 (over 65535);
// then, for each reference ray and colour, the share of their weight that those have. Needs lib/wavelet.glsl.
layout(constant_id = 16) const int kBits = 10;
layout(constant_id = 17) const int kLevels = 10;       // built and walked
layout(constant_id = 18) const int kBinBits = 11;      // of the table of ranks
layout(constant_id = 19) const int kVectors = 1;       // texels of four channels a position
const int kElements = 1 << kBits;
const int kBins = 1 << kBinBits;  // and one for what nothing blocks
const float kCountScale = 65535.0;  // counts in 16-bit unorm and float alike

// Positions run along y, as columns do in the rectified map: neighbouring invocations, each on a row of its own, store neighbouring texels.
// Where a workgroup builds a row its invocations are neighbours along the row, and positions run along x.
layout(constant_id = 24) const bool kAlongX = false;
ivec3 levelTexel(int slice, int position, int layer) {
  return kAlongX ? ivec3(position, slice, layer) : ivec3(slice, position, layer);
}
