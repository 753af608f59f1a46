// How far a picture is from its reference. Used by tests and by the benchmark.
#pragma once

#include "base/result.hpp"
#include "image/image_io.hpp"

namespace tyndall::image {

/// Each figure is divided by the reference's mean, and taken over all pixels and the channels R,G,B (or the only
/// channel) together; alpha does not count. Accumulated in double.
struct ErrorMetrics {
  double nRmse = 0;          ///< sqrt(mean((image - reference)^2)) / mean
  double p99 = 0;            ///< 99th percentile (nearest rank) of |image - reference| / mean
  double max = 0;            ///< greatest |image - reference| / mean
  double bias = 0;           ///< mean(image - reference) / mean; negative: the image is too dark
  double referenceMean = 0;  ///< the mean itself, in the pictures' unit
};

/// Errors: sizes or channel counts differ (RGB against RGBA is fine), a value is not finite (the first such pixel is
/// named), or the reference's mean is not positive, so that nothing can be divided by it.
Result<ErrorMetrics> compare(const FloatImage& image, const FloatImage& reference);

}  // namespace tyndall::image
