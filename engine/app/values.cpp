#include "app/values.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tyndall::app {
namespace {

/// Digits only. Numbers beyond 64 bits become the greatest one, which every range then refuses.
bool readDigits(const std::string& text, std::uint64_t& value) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) return false;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code == std::errc::result_out_of_range) value = std::numeric_limits<std::uint64_t>::max();
  return true;
}

}  // namespace

Result<std::uint32_t> readCount(const std::string& option, const std::string& text, std::uint32_t low,
                                std::uint32_t high) {
  std::uint64_t value = 0;
  if (!readDigits(text, value) || value < low || value > high)
    return badCall(option + " '" + text + "': must be a whole number from " + std::to_string(low) + " to " +
                   std::to_string(high));
  return static_cast<std::uint32_t>(value);
}

Result<std::pair<std::uint32_t, std::uint32_t>> readSize(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  std::uint64_t width = 0, height = 0;
  if (cross == std::string::npos || !readDigits(text.substr(0, cross), width) ||
      !readDigits(text.substr(cross + 1), height) || width < 1 || height < 1)
    return badCall(option + " '" + text + "': must be WIDTHxHEIGHT in pixels, each 1 or more, such as 1280x720");
  constexpr std::uint64_t top = std::numeric_limits<std::uint32_t>::max();
  return std::pair{static_cast<std::uint32_t>(std::min(width, top)), static_cast<std::uint32_t>(std::min(height, top))};
}

Result<void> checkSize(const std::string& option, std::pair<std::uint32_t, std::uint32_t> size, std::uint32_t limit,
                       const std::string& what) {
  if (size.first <= limit && size.second <= limit) return {};
  return badCall(option + " " + std::to_string(size.first) + "x" + std::to_string(size.second) + ": " + what +
                 " at most " + std::to_string(limit) + " pixels a side");
}

Result<double> readSeconds(const std::string& option, const std::string& text) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) || value < 0 || value > 1e9)
    return badCall(option + " '" + text + "': must be a number of seconds from 0 to 1000000000");
  return value;
}

Result<double> readPositive(const std::string& option, const std::string& text) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) || value <= 0)
    return badCall(option + " '" + text + "': must be a number above 0");
  return value;
}

Result<double> readBetween(const std::string& option, const std::string& text, double low, double high) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size() || !(value >= low && value <= high)) {
    char range[64];
    std::snprintf(range, sizeof range, "%g to %g", low, high);
    return badCall(option + " '" + text + "': must be a number from " + range);
  }
  return value;
}

}  // namespace tyndall::app
