// Relative weights of columns for the reference rays: a factor that all columns of a row share is left out, since only shares are stored.
// Needs stages/rows.glsl and stages/reference_rays.glsl.

// Per reference ray: the falloff of the weight a column, in powers of two, or, where columns are not even, the optical depth a metre of
// distance from the axis.
void setFalloff(Slice s, out float falloff[kReferenceRays]) {
  float width = (s.last - s.first) / float(light.map.columns);
  for (int k = 0; k < kReferenceRays; ++k) {
    float tau = referenceTau(s, k, kReferenceRays);
    falloff[k] = byTangent() ? tau : tau * width * 1.4426950408889634;  // log2(e)
  }
}

float columnWeight(Slice s, float falloff, int column) {
  if (!byTangent()) return exp2(-falloff * float(column));
  return transmittanceIntegral(falloff, columnDistance(s, float(column)), columnDistance(s, float(column + 1)));
}
