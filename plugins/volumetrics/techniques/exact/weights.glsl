// Relative weights of columns for the reference rays: a factor that all columns of a row share is left out, since only shares are stored.
// Needs stages/rows.glsl, stages/reference_rays.glsl, stages/channels.glsl and the binding `columnWeights`.

// Per reference ray: the falloff of the weight a column, in powers of two, or, where columns are not even, the optical depth a metre of
// distance from the axis.
void setFalloff(Slice s, out float falloff[kReferenceRays]) {
  float width = (s.last - s.first) / float(light.map.columns);
  for (int k = 0; k < kReferenceRays; ++k) {
    float tau = kShaped ? 0.0 : referenceKey(s, k, kReferenceRays);
    falloff[k] = byTangent() ? tau : tau * width * 1.4426950408889634;  // log2(e)
  }
}

// Weights of a column in all channels. Where light rays differ they were computed before (stages/shine.comp.glsl).
void columnWeight(int slice, Slice s, float falloff[kReferenceRays], int column, out float weight[kChannelSlots]) {
  for (int i = kChannels; i < kChannelSlots; ++i) weight[i] = 0.0;
  if (kShaped) {
    int last = int(totalColumns()) - 1;
    for (int i = 0; i < kChannelQuads; ++i) {
      vec4 four = column <= last ? texelFetch(columnWeights, ivec3(slice, column, i), 0) : vec4(0.0);
      for (int c = 0; c < 4; ++c) weight[4 * i + c] = four[c];
    }
    return;
  }
  for (int k = 0; k < kReferenceRays; ++k)
    weight[k] = byTangent() ? transmittanceIntegral(falloff[k], columnDistance(s, float(column)), columnDistance(s, float(column + 1)))
                            : exp2(-falloff[k] * float(column));
}
