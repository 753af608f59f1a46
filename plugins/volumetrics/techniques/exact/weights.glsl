// Relative weights of columns for the reference rays: a factor that all columns of a row share is left out, since only shares are stored.
// Needs stages/rows.glsl, stages/reference_rays.glsl, stages/channels.glsl and the binding `columnWeights`.

const float kLog2e = 1.4426950408889634;

// The weight of column u is exp2(-u (linear + square u)) times its width and fullness (lib/epipolar.glsl), or, where columns follow a projective
// map, found from the optical depth a metre alone.
struct Falloff {
  float linear, square;
  float depth;  // optical depth of the first column, or a metre's
};

void setFalloff(Slice s, out Falloff falloff[kReferenceRays], out float growth) {
  float count = float(light.map.columns);
  float width = (s.last - s.first) / count;
  float first = width * columnsReach(s.nearest, 1.0 / count) * count;
  float more = 2.0 * width * (1.0 - s.nearest) / count;  // each column than the one before it
  growth = first > 0.0 ? more / first : 0.0;
  for (int k = 0; k < kReferenceRays; ++k) {
    float tau = kShaped ? 0.0 : referenceKey(s, k, kReferenceRays);
    falloff[k].linear = tau * first * kLog2e;
    falloff[k].square = tau * 0.5 * more * kLog2e;
    falloff[k].depth = byTangent() ? tau : tau * first;
  }
}

// Weights of a column in all channels. Where light rays differ they were computed before (stages/shine.comp.glsl).
void columnWeight(int slice, Slice s, Falloff falloff[kReferenceRays], float growth, int column, out float weight[kChannelSlots]) {
  for (int i = kChannels; i < kChannelSlots; ++i) weight[i] = 0.0;
  if (kShaped) {
    int last = int(totalColumns()) - 1;
    for (int i = 0; i < kChannelQuads; ++i) {
      vec4 four = column <= last ? texelFetch(columnWeights, ivec3(slice, column, i), 0) : vec4(0.0);
      for (int c = 0; c < 4; ++c) weight[4 * i + c] = four[c];
    }
    return;
  }
  float u = float(column);
  float width = 1.0 + growth * u;
  for (int k = 0; k < kReferenceRays; ++k)
    weight[k] = byTangent() ? transmittanceIntegral(falloff[k].depth, columnDistance(s, u), columnDistance(s, u + 1.0))
                            : exp2(-u * (falloff[k].linear + falloff[k].square * u)) * width * columnFullness(falloff[k].depth * width);
}
