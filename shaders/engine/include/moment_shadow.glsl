// Shadows from a filtered four-moment shadow map (Peters et al. 2017, "Improved Moment Shadow Maps for Translucent Occluders,
// Soft Shadows and Single Scattering", sections 2.2.1, 2.5, 2.6 and appendix D.2; the maps: moments_blur.comp).
// Of all depth distributions with the moments sampled, the one that shadows least counts (equation 1): the sharp upper bound of
// visibility, so that a surface does not shadow itself.
// Deviations: the pixel's footprint comes from the surface's plane, not from differences between neighbouring pixels, which are
// wrong where one lies on another surface; the receiver is moved as for plain shadow maps (shadow.glsl) by as much as the filter
// reaches, not by a fixed depth; for the bias at 128 bits see kBias.
#ifndef TYNDALL_MOMENT_SHADOW_GLSL
#define TYNDALL_MOMENT_SHADOW_GLSL
#include "engine/include/linear_depth.glsl"
#include "engine/include/shadow.glsl"
#include "lib/portable.h"
#include "lib/moments.glsl"

// The includer declares `ViewBlock view` and the specialization constant SHADOW_MAPS beside what shadow.glsl asks for.
const uint kDepths = 0u, kQuantisedMoments = 1u;  // 2: moments as they are

// Trilinear samples along a footprint, at most, and so the elongation beyond which a footprint is cut: at flatter views the
// filter is too short rather than too wide. (Anisotropic samplers do the same, but take 100 times as long on llvmpipe.)
const float kMostSamples = 4.0;
// Variance of the map's own Gaussian, and of bilinear filter and mips per square texel of the pixel's footprint, in texels.
const float kGaussianVariance = 2.25;
const float kFootprintVariance = 0.25;
// On a plane, depths in the filter spread like places do. The least shadow compatible with any symmetric distribution is none
// up to one standard deviation before its mean; a quarter more is for the asymmetry of cut and sampled ones, as at the edge of a face
// of a cube, where the last texel goes on.
const float kOffsetDeviations = 1.25;
// Moment bias and the even entries of the bias vector. 128 bits: the paper's 3e-7 is below what rounding alone needs
// (docs/results/stress.md); 1e-6 is safe.
const float kBias = SHADOW_MAPS == kQuantisedMoments ? 6e-5 : 1e-6;
const float kBiasTarget = SHADOW_MAPS == kQuantisedMoments ? 0.628 : 0.375;
// Shadows are divided by this and cut at 1, so that light leaking below 2 percent disappears (section 2.6).
const float kOverDarkening = 0.98;

// How far the point that a pixel sees moves over the surface's plane from this pixel to the next along x and along y.
void pixelFootprint(vec3 position, vec3 normal, out vec3 alongX, out vec3 alongY) {
  vec3 ray = position - view.eye;
  float depth = -dot(view.worldFromView[2].xyz, ray);
  vec3 stepX = view.worldFromView[0].xyz * (2.0 * view.viewFromClip[0][0] * depth / float(view.size.x));
  vec3 stepY = view.worldFromView[1].xyz * (2.0 * view.viewFromClip[1][1] * depth / float(view.size.y));
  float facing = dot(normal, ray);
  float least = length(ray) / kMostSamples;
  facing = facing < 0.0 ? min(facing, -least) : max(facing, least);
  alongX = stepX - ray * (dot(normal, stepX) / facing);
  alongY = stepY - ray * (dot(normal, stepY) / facing);
}

// Mean of the stored moments over a pixel's footprint, whose sides are `alongX` and `alongY` in texture space.
vec4 sampleMoments(sampler2DArray map, float size, vec3 at, vec2 alongX, vec2 alongY) {
  float sizeX = length(alongX) * size;
  float sizeY = length(alongY) * size;
  vec2 along = sizeX > sizeY ? alongX : alongY;
  float longer = max(sizeX, sizeY);
  float samples = clamp(ceil(longer / max(min(sizeX, sizeY), 1.0)), 1.0, kMostSamples);
  float lod = max(log2(max(max(min(sizeX, sizeY), longer / samples), 1.0)), 0.0);
  vec4 sum = vec4(0.0);
  for (float i = 0.5; i < samples; i += 1.0) sum += textureLod(map, at + vec3(along * (i / samples - 0.5), 0.0), lod);
  return sum / samples;
}

// Share of light that arrives, [0, 1].
float momentFilter(sampler2DArray map, uint slot, vec3 position, vec3 normal, vec3 towardsLight) {
  uint face = shadowFace(slot, position);
  vec4 clip = shadowedLights[slot].clipFromWorld[face] * vec4(position, 1.0);
  if (clip.w <= 0.0) return 1.0;  // behind a spot light
  vec3 alongX, alongY;
  pixelFootprint(position, normal, alongX, alongY);
  vec4 clipX = shadowedLights[slot].clipFromWorld[face] * vec4(alongX, 0.0);
  vec4 clipY = shadowedLights[slot].clipFromWorld[face] * vec4(alongY, 0.0);
  // The map is two units of clip space wide and one of texture space.
  vec2 gradientX = 0.5 * (clipX.xy - clip.xy / clip.w * clipX.w) / clip.w;
  vec2 gradientY = 0.5 * (clipY.xy - clip.xy / clip.w * clipY.w) / clip.w;
  float texels = shadowedLights[slot].shadowSize * max(length(gradientX), length(gradientY));
  float deviation = sqrt(kGaussianVariance + kFootprintVariance * max(texels * texels, 1.0));
  vec4 place = shadowPlace(slot, position, normal, towardsLight, kOffsetDeviations * deviation);
  if (any(greaterThan(abs(place.xy), vec2(1.0)))) return 1.0;
  vec4 b = sampleMoments(map, shadowedLights[slot].shadowSize, vec3(place.xy * 0.5 + 0.5, place.w), gradientX, gradientY);
  if (SHADOW_MAPS == kQuantisedMoments) b = dequantise4(b);
  // Beyond the far plane nothing casts a shadow: the receiver stands with the empty background at 1.
  float z = clamp(2.0 * linearDepth(place.z, shadowedLights[slot].depthCurve) - 1.0, -1.0, 1.0);
  float shadow = 1.0 - visibility4(bias4(b, kBias, kBiasTarget), z, 1.0);
  return 1.0 - min(shadow / kOverDarkening, 1.0);
}

#endif
