// The table of unshadowed integrals of a spot or point light (as Peters et al. 2017 tabulate theirs, section 5.1.2): for inclination j and share i
// of the range of psi, the mean of localWeight() over that share of the range. A workgroup an inclination; each invocation integrates
// neighbouring cells by two-point Gauss-Legendre quadrature, and adds what those before it found.
// Input: the light. Output: R32F, shares along x, inclinations along y; read by unshadowedTo() in stages/rays_on_rows.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "stages/rectified.h"

const int kLanes = 32;
layout(local_size_x = 32) in;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform writeonly image2DArray unshadowed;

#include "stages/opaque.glsl"

shared float sums[kLanes];

const float kNode = 0.5773502691896258;  // 1/sqrt(3)

float cell(float theta, float whole, float from, float width) {
  float sum = 0.0;
  for (int i = 0; i < 2; ++i)
    sum += localWeight(theta, whole * (from + width * (0.5 + 0.5 * (i == 0 ? -kNode : kNode))), frame.rays.sigma_t * light.distance,
                       opaque(frame.rays.g), opaque(light.local.range / light.distance), 1e9, 0.0);
  return 0.5 * width * sum;
}

void main() {
  int size = imageSize(unshadowed).x;
  int cells = size / kLanes;
  int row = int(gl_WorkGroupID.x);
  int lane = int(gl_LocalInvocationID.x);
  float theta = mix(light.thetaLow, light.thetaHigh, float(row) / float(size - 1));
  float whole = max(3.14159265358979 - theta, 1e-7);
  float width = 1.0 / float(size);
  float own = 0.0;
  for (int i = 0; i < cells; ++i) own += cell(theta, whole, float(lane * cells + i) * width, width);
  sums[lane] = own;
  barrier();
  float sum = 0.0;
  for (int i = 0; i < lane; ++i) sum += sums[i];
  for (int i = 0; i < cells; ++i) {
    sum += cell(theta, whole, float(lane * cells + i) * width, width);
    imageStore(unshadowed, ivec3(lane * cells + i, row, 0), vec4(sum));
  }
}
