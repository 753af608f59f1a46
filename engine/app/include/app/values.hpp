// Text of the command line as numbers, strictly: the whole text or a bad call that names the option.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "base/result.hpp"

namespace tyndall::app {

/// A whole number in [low, high]; no sign other than none, no spaces, no fraction.
Result<std::uint32_t> readCount(const std::string& option, const std::string& text, std::uint32_t low,
                                std::uint32_t high);
/// "1280x720". Sides are 1 or more; the device's limit is checked where the device is known (checkSide).
Result<std::pair<std::uint32_t, std::uint32_t>> readSize(const std::string& option, const std::string& text);
/// Sides of at most `limit` pixels; `what` says whose limit it is ("llvmpipe takes").
Result<void> checkSize(const std::string& option, std::pair<std::uint32_t, std::uint32_t> size, std::uint32_t limit,
                       const std::string& what);
/// A finite number of seconds, 0 or more.
Result<double> readSeconds(const std::string& option, const std::string& text);
/// A finite number above 0.
Result<double> readPositive(const std::string& option, const std::string& text);
/// A number within [low, high].
Result<double> readBetween(const std::string& option, const std::string& text, double low, double high);

}  // namespace tyndall::app
