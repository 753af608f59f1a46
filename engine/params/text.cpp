// Values as text and back, and the checks that every value passes.
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/assert.hpp"
#include "base/file.hpp"
#include "message.hpp"
#include "params/params.hpp"

namespace tyndall::params {
namespace {

/// Shortest text that reads back to the same double.
std::string number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

std::string rangeText(const Parameter& p) { return number(p.min) + " to " + number(p.max); }

std::string choicesText(const Parameter& p) {
  std::string text;
  for (const std::string& choice : p.choices) text += (text.empty() ? "" : ", ") + choice;
  return text;
}

std::string wanted(const Parameter& p) {
  switch (p.type) {
    case Type::kBool: return "true or false";
    case Type::kInt: return "a whole number from " + rangeText(p);
    case Type::kFloat: return "a number from " + rangeText(p);
    case Type::kEnum: return "one of " + choicesText(p);
  }
  return "";
}

Error refuse(const Parameter& p, const std::string& what) {
  return badCall(p.id + ": " + what + "; give " + wanted(p));
}

std::string builtNames(const Parameter& p) {
  std::string text;
  for (std::size_t i = 0; i < p.choices.size(); ++i)
    if (p.built.empty() || (i < p.built.size() && p.built[i])) text += (text.empty() ? "" : ", ") + p.choices[i];
  return text;
}

Error notBuilt(const Parameter& p, double value) {
  std::string right;
  if (p.type == Type::kEnum)
    right = "built are: " + builtNames(p);
  else if (p.type == Type::kBool)
    right = "use " + toText(p, value == 0 ? 1 : 0);
  else
    right = "built are values from " + number(p.builtMin) + " to " + number(p.builtMax);
  return badCall(p.id + ": " + quote(toText(p, value)) + " is not built yet; " + right);
}

Result<double> fromChoice(const Parameter& p, std::string_view text) {
  for (std::size_t i = 0; i < p.choices.size(); ++i)
    if (p.choices[i] == text) return check(p, static_cast<double>(i));
  const std::string near = nearestName(text, p.choices);
  return refuse(p, "there is no choice " + quote(text) + (near.empty() ? "" : " (did you mean " + quote(near) + "?)"));
}

}  // namespace

std::string toText(const Parameter& parameter, double value) {
  switch (parameter.type) {
    case Type::kBool: return value != 0 ? "true" : "false";
    case Type::kEnum: {
      const bool inside = value >= 0 && value < static_cast<double>(parameter.choices.size());
      TY_ASSERT(inside, parameter.id + " = " + number(value));
      return parameter.choices[static_cast<std::size_t>(value)];
    }
    case Type::kInt:
      // Every double up to 2^53 that is a whole number prints without a fraction or an exponent.
      if (std::abs(value) < 9e15) return std::to_string(static_cast<long long>(value));
      return number(value);
    case Type::kFloat: return number(value);
  }
  return number(value);
}

Result<double> fromText(const Parameter& parameter, std::string_view text) {
  if (parameter.type == Type::kEnum) return fromChoice(parameter, text);
  if (parameter.type == Type::kBool) {
    if (text == "true" || text == "1" || text == "on") return check(parameter, 1);
    if (text == "false" || text == "0" || text == "off") return check(parameter, 0);
    return refuse(parameter, quote(text) + " is neither true nor false");
  }
  const char* end = text.data() + text.size();
  if (parameter.type == Type::kInt) {
    long long whole = 0;
    const auto read = std::from_chars(text.data(), end, whole);
    if (text.empty() || read.ptr != end) return refuse(parameter, quote(text) + " is not a whole number");
    if (read.ec == std::errc::result_out_of_range) return refuse(parameter, quote(text) + " is outside the range");
    return check(parameter, static_cast<double>(whole));
  }
  double value = 0;
  const auto read = std::from_chars(text.data(), end, value);
  if (text.empty() || read.ptr != end) return refuse(parameter, quote(text) + " is not a number");
  if (read.ec == std::errc::result_out_of_range) return refuse(parameter, quote(text) + " is outside the range");
  return check(parameter, value);
}

Result<double> check(const Parameter& parameter, double value) {
  if (!std::isfinite(value)) return refuse(parameter, "the value is not a finite number");
  if (parameter.type != Type::kFloat && value != std::floor(value))
    return refuse(parameter, quote(number(value)) + " is not a whole number");
  if (parameter.type == Type::kBool || parameter.type == Type::kEnum) {
    const double count = parameter.type == Type::kBool ? 2 : static_cast<double>(parameter.choices.size());
    if (value < 0 || value >= count) return refuse(parameter, number(value) + " is no choice");
    const auto choice = static_cast<std::size_t>(value);
    if (choice < parameter.built.size() && !parameter.built[choice]) return notBuilt(parameter, value);
    return value + 0.0;  // never -0
  }
  if (value < parameter.min || value > parameter.max) return refuse(parameter, number(value) + " is outside the range");
  if (value < parameter.builtMin || value > parameter.builtMax) return notBuilt(parameter, value);
  return value;
}

}  // namespace tyndall::params
