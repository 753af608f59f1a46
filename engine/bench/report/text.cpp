#include "text.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace tyndall::bench::report {
namespace {

std::string toChars(double value, std::chars_format format, int precision) {
  char buffer[512];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format, precision);
  return std::string(buffer, end.ptr);
}

}  // namespace

std::string figure(double value, int digits) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return "–";
  const std::string sign = value < 0 ? "−" : "";
  // Scientific first: its exponent is the one after rounding (9.996 -> 1.00e+01).
  const std::string scientific = toChars(std::abs(value), std::chars_format::scientific, digits - 1);
  const std::size_t e = scientific.find('e');
  const int exponent = std::atoi(scientific.c_str() + e + 1);
  if (exponent < -5 || exponent > 6)
    return sign + scientific.substr(0, e) + "e" + (exponent < 0 ? "−" : "") + std::to_string(std::abs(exponent));
  if (exponent >= digits) return sign + whole(std::abs(value));
  return sign + toChars(std::abs(value), std::chars_format::fixed, std::max(0, digits - 1 - exponent));
}

std::string figureOrDash(const std::optional<double>& value, int digits) {
  return value ? figure(*value, digits) : "–";
}

std::string whole(double value) {
  std::string text = toChars(std::round(std::abs(value)), std::chars_format::fixed, 0);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return std::string(value < 0 ? "−" : "").append(text);
}

std::string bytes(double count) {
  if (count < 1e3) return figure(count) + " B";
  if (count < 1e6) return figure(count / 1e3) + " kB";
  return count < 1e9 ? figure(count / 1e6) + " MB" : figure(count / 1e9) + " GB";
}

std::string percent(double share) { return figure(100 * share) + " %"; }

std::string list(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

std::string exact(double value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end.ptr);
}

std::string plural(std::size_t count, const std::string& singular) { return count == 1 ? singular : singular + "s"; }

std::string shortId(const std::string& id) {
  const std::size_t dot = id.rfind('.');
  return dot == std::string::npos || dot + 1 == id.size() ? id : id.substr(dot + 1);
}

}  // namespace tyndall::bench::report
