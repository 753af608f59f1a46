// Numbers and lists as a reader wants them, whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tyndall::bench::report {

/// `digits` significant digits: "0.0186", "205", "1.24e-7"; a real minus sign.
std::string figure(double value, int digits = 3);
/// figure(), or a dash where there is none.
std::string figureOrDash(const std::optional<double>& value, int digits = 3);
/// Digits without rounding to a few: "1048576" as "1,048,576".
std::string whole(double value);
/// "24.1 MB" (10⁶ bytes).
std::string bytes(double count);
/// A share of 1 as "12.3 %".
std::string percent(double share);
/// "a, b and c".
std::string list(const std::vector<std::string>& items);
/// Shortest text that reads back as the same number, for data attributes.
std::string exact(double value);
/// 1 -> "point", else "points".
std::string plural(std::size_t count, const std::string& singular);
/// The part after the last dot: "columns" of "volumetrics.columns".
std::string shortId(const std::string& id);

}  // namespace tyndall::bench::report
