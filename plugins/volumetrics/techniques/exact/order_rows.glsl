// What rows in the order of depth are made of (lib/depth_order.glsl). For every row, slices along x:
//   ranks   texel b: how many columns lie in depth bins before border b, over 65535;
//   order   records of 32 neighbours in the order, kRecordTexels texels each: words of counts, then kBlockBits planes of block numbers;
//   places  kPlaceTexels texels for every 32 columns: planes of the ranks that columns have within their block.
// Needs lib/depth_order.glsl and stages/rows.glsl.
layout(constant_id = 16) const int kBits = 10;       // 2^kBits columns at most
layout(constant_id = 18) const int kBinBits = 11;    // of the table of ranks
layout(constant_id = 29) const int kBlockBits = 5;   // 3 to 6: 2^kBlockBits blocks at most
layout(constant_id = 30) const bool kWideCounts = false;  // 16 bits a count instead of 8: blocks of 256 columns or more
const int kElements = 1 << kBits;
const int kBins = 1 << kBinBits;
const int kBlocks = 1 << kBlockBits;
const int kCountBits = kWideCounts ? 16 : 8;
const int kCountWords = kBlocks * kCountBits / 32;
const int kRecordTexels = (kCountWords + kBlockBits + 3) / 4;
const int kPlaceBits = kBits - kBlockBits;  // of a column's number within its block
const int kPlaceTexels = (kPlaceBits + 3) / 4;
const float kCountScale = 65535.0;

// Columns of a block are 1 << shift, of the columns that the row has in this frame.
int rowShift() { return blockShift(int(totalColumns()), kBlockBits); }
