// Reads the lit channels of stages/lit.comp.glsl. Needs stages/channels.glsl, stages/reference_rays.glsl and the binding `lit` (linear filter).

// Channels at texel coordinate `column` of a row, interpolated along it: (k, colour) is value[k * kColours + colour].
void litChannels(int slice, float column, out float value[kChannelSlots]) {
  vec2 at = vec2((float(slice) + 0.5) / float(textureSize(lit, 0).x), column / float(textureSize(lit, 0).y));
  for (int i = 0; i < kChannelQuads; ++i) {
    vec4 four = kShaped ? textureLod(lit, vec3(at, float(i)), 0.0) : vec4(1.0);
    for (int c = 0; c < 4; ++c) value[4 * i + c] = four[c];
  }
}

// A value of each reference ray and colour, interpolated between the reference rays.
vec3 betweenReferenceRays(float value[kChannelSlots], float share[kReferenceRays]) {
  vec3 sum = vec3(0.0);
  for (int k = 0; k < kReferenceRays; ++k)
    for (int c = 0; c < 3; ++c) sum[c] += share[k] * value[k * kColours + (kColoured ? c : 0)];
  return sum;
}
