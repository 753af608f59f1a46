// Errors of a picture against a reference, split by where they lie.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "bench/results.hpp"
#include "image/image_io.hpp"
#include "scene/scene.hpp"

namespace tyndall::bench {

/// Where the lights stand in a picture of `size` pixels: from the upper left corner, y down; of suns the direction to
/// them. Those behind the camera are left out; others may lie outside the picture.
std::vector<glm::vec2> lightsInPicture(const std::vector<scene::LightView>& lights, const scene::CameraView& camera,
                                       Size size);
bool insidePicture(const std::vector<glm::vec2>& places, Size size);

/// `picture` with the reference's pixels where the two end on different surfaces (transmittances more than 0.01 apart):
/// what rasteriser and ray tracer see differently at silhouettes is no error of a technique.
image::FloatImage onSameSurface(const image::FloatImage& picture, const image::FloatImage& reference);

/// Both pictures: R,G,B radiance, A transmittance to the surface, of one size; `distance`: the reference's, metres
/// along the ray, or empty. A pixel belongs to the light within 16 pixels of one; else to silhouettes where a
/// neighbour's distance differs by more than 5 % or the two transmittances by more than 0.01 (another surface was hit);
/// else to the interior. Errors: sizes differ, a value is not finite, the reference is black.
Result<SplitErrors> splitErrors(const image::FloatImage& picture, const image::FloatImage& reference,
                                const std::vector<float>& distance, const std::vector<glm::vec2>& lights);

}  // namespace tyndall::bench
