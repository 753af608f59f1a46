#include "image/metrics.hpp"

#include <algorithm>
#include <cmath>

#include "checks.hpp"

namespace tyndall::image {
namespace {

std::uint32_t colourChannels(const FloatImage& image) { return std::min(image.channels, 3u); }

}  // namespace

Result<ErrorMetrics> compare(const FloatImage& image, const FloatImage& reference) {
  assertComplete(image);
  assertComplete(reference);
  const std::uint32_t channels = colourChannels(reference);
  if (image.width != reference.width || image.height != reference.height || colourChannels(image) != channels)
    return failed("the pictures differ in shape: " + sizeText(image.width, image.height) + "x" +
                  std::to_string(image.channels) + " against " + sizeText(reference.width, reference.height) + "x" +
                  std::to_string(reference.channels) + "; they must be of one size and both coloured or both not");
  std::vector<double> errors;
  errors.reserve(std::size_t{reference.width} * reference.height * channels);
  double sum = 0, difference = 0, squares = 0;
  for (std::uint32_t y = 0; y < reference.height; ++y)
    for (std::uint32_t x = 0; x < reference.width; ++x)
      for (std::uint32_t c = 0; c < channels; ++c) {
        const double a = image.at(x, y, c), b = reference.at(x, y, c);
        if (!std::isfinite(a) || !std::isfinite(b))
          return failed("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") of the " +
                        (std::isfinite(a) ? "reference" : "picture") + " is not finite");
        sum += b;
        difference += a - b;
        squares += (a - b) * (a - b);
        errors.push_back(std::abs(a - b));
      }
  const double count = static_cast<double>(errors.size());
  const double mean = sum / count;
  if (errors.empty() || !(mean > 0)) return failed("the reference's mean is not positive; relative errors need one");
  const std::size_t rank = (99 * errors.size() + 99) / 100 - 1;  // nearest rank: ceil(0.99 n), counted from 0
  const auto p99 = errors.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(errors.begin(), p99, errors.end());
  const double greatest = *std::max_element(p99, errors.end());
  return ErrorMetrics{std::sqrt(squares / count) / mean, *p99 / mean, greatest / mean, difference / count / mean, mean};
}

}  // namespace tyndall::image
