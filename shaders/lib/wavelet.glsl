// Weighted dominance sums by a wavelet matrix (Claude, Navarro, Ordonez 2015, "The wavelet matrix: an efficient wavelet tree for large
// alphabets"; weights as in Makris 2012) in rank space: the elements of a row have the ranks 0 ... 2^bits - 1, each once. At level l a
// node holds the 2^(bits - l) ranks that agree in their first l bits, in the row's order; the next bit parts it into halves.
// A query asks which share of the weight of the first elements of the row belongs to ranks below a real number `rank`: it follows
// the bits of the rank, one node a level, and never asks for more than the shares of a prefix of a node.

// Bin of a normalised depth: 2^binBits over [0, 1), and one more for 1, where nothing blocks.
LIB int waveletBin(Real depth, int binBits) {
  int bins = 1 << binBits;
  int bin = int(depth * Real(bins));
  return bin < 0 ? 0 : (bin > bins ? bins : bin);
}

// First position of the node of `level` that holds `rank`.
LIB int waveletNode(int rank, int level, int bits) { return (rank >> (bits - level)) << (bits - level); }
// Whether `rank` belongs to the second half of its node of `level`.
LIB bool waveletOne(int rank, int level, int bits) { return ((rank >> (bits - 1 - level)) & 1) != 0; }

// What a texel stores: the share of a prefix's weight that the first half of the ranks has. Nothing weighs nothing: any share will do.
LIB Real waveletShare(Real ofZeros, Real ofAll) { return ofAll > R(0.0) ? ofZeros / ofAll : R(0.5); }

// One level of a query. x: the share found below the rank so far, y: the share that is still undecided; both of the whole prefix's
// weight. `share`: of the undecided weight, what the node's first half has. The rank lies in the second half (`one`): the first is below it.
LIB Real2 waveletStep(Real2 found, Real share, bool one) {
  Real first = found.y * share;
  return one ? Real2(found.x + first, found.y - first) : Real2(found.x, first);
}

// The end: a node of 2^(bits - level) ranks is left, and weighed as if its weight were spread over them evenly. `followed` is the whole
// number whose bits were followed: the rank rounded down, or the last rank of all where every rank is below.
LIB Real waveletEnd(Real2 found, Real rank, int followed, int level, int bits) {
  Real size = Real(1 << (bits - level));
  Real into = (rank - Real(waveletNode(followed, level, bits))) / size;
  return found.x + found.y * clamp(into, R(0.0), R(1.0));
}
