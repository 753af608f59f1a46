// Cube maps: which face a vector falls on, and where (Vulkan 1.3, "Cube Map Face Selection and Transformations").
// Include lib/portable.h first. No include guard on purpose: C++ includes this text once for each precision.

// Face by the major axis, in the order +X -X +Y -Y +Z -Z.
LIB uint cubeFace(Real3 d) {
  Real3 a = abs(d);
  bool x = a.x >= a.y && a.x >= a.z;
  return x ? (d.x < R(0.0) ? 1u : 0u) : a.y >= a.z ? (d.y < R(0.0) ? 3u : 2u) : (d.z < R(0.0) ? 5u : 4u);
}

// (s, -t, 0, major axis) of a vector on a face: linear in the vector while the face stays.
LIB Real4 cubePlace(uint face, Real3 d) {
  if (face == 0u) return Real4(-d.z, d.y, R(0.0), d.x);
  if (face == 1u) return Real4(d.z, d.y, R(0.0), -d.x);
  if (face == 2u) return Real4(d.x, -d.z, R(0.0), d.y);
  if (face == 3u) return Real4(d.x, d.z, R(0.0), -d.y);
  if (face == 4u) return Real4(d.x, d.y, R(0.0), d.z);
  return Real4(-d.x, d.y, R(0.0), -d.z);
}
