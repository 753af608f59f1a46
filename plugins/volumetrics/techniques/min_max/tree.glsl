// Where the nodes of a row's min-max tree lie. A node of level l covers 2^l columns; level 0 is the rectified map itself. Levels 1 to
// 6 are in the image `low`, built 64 columns at a time; levels 7 and up in `high`. Rows of both images: levels one behind the other.
const int kChunkLevels = 6;
const int kChunk = 64;

// Columns rounded up to whole chunks.
int paddedColumns(int columns) { return (columns + kChunk - 1) / kChunk * kChunk; }
// First row of level l, 1...6, in `low`.
int lowOffset(int padded, int level) { return padded - (padded >> (level - 1)); }
// Chunks rounded up to a power of two.
int paddedChunks(int padded) {
  int chunks = padded / kChunk;
  int rounded = 1;
  while (rounded < chunks) rounded *= 2;
  return rounded;
}
// First row of level l >= 7 in `high`.
int highOffset(int chunks, int level) { return chunks - (chunks >> (level - kChunkLevels - 1)); }
