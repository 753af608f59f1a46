// PCG hash (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering"): white noise in [0, 1).
float whiteNoise(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return float(v.x >> 8) * (1.0 / 16777216.0);
}
