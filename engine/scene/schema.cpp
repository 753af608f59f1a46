#include "schema.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tyndall::scene {
namespace {

/// Where a value stands and what it is checked against.
struct Place {
  const Property& property;
  const Json& document;
  const std::string path;
  Warnings& warnings;
};

std::string number(double v) {
  Json j = v;
  if (v == std::floor(v) && std::abs(v) < 1e15) j = static_cast<std::int64_t>(v);
  return j.dump();
}

std::string rangeText(const Property& p) {
  constexpr double kUnbounded = std::numeric_limits<float>::max();
  if (p.low == -kUnbounded && p.high == kUnbounded) return "a number that fits in a float";
  if (p.high == kUnbounded) return "at least " + number(p.low);
  return "from " + number(p.low) + " to " + number(p.high);
}

void checkChoice(const Place& at, const std::string& text) {
  if (!at.property.choices) return;
  std::string_view rest = at.property.choices;
  while (!rest.empty()) {
    const std::size_t bar = std::min(rest.find('|'), rest.size());
    if (rest.substr(0, bar) == text) return;
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  std::string list = at.property.choices;
  std::replace(list.begin(), list.end(), '|', ' ');
  refuse(at.path + " is " + inQuotes(text) + "; known are " + list);
}

double checkedNumber(const Json& value, const Place& at) {
  if (!value.is_number()) refuse(at.path + " is not a number");
  const double v = value.get<double>();
  if (v >= at.property.low && v <= at.property.high) return v;
  if (!at.property.clamp) refuse(at.path + " is " + number(v) + "; it must be " + rangeText(at.property));
  at.warnings.add(at.path + " is " + number(v) + ", not " + rangeText(at.property) + "; the nearest is used");
  return std::clamp(v, at.property.low, at.property.high);
}

std::int64_t checkedInteger(const Json& value, const Place& at) {
  if (!value.is_number()) refuse(at.path + " is not an integer");
  const double v = value.get<double>();
  // Whole numbers up to 2^53 are exact in a double; every bound in the schema is below.
  if (v != std::floor(v) || std::abs(v) > 9e15) refuse(at.path + " is not an integer");
  if (v < at.property.low || v > at.property.high)
    refuse(at.path + " is " + number(v) + "; it must be " + rangeText(at.property));
  checkChoice(at, number(v));
  return static_cast<std::int64_t>(v);
}

/// "name" is an array of the document; "extension.name" one of an extension's object at its root.
std::size_t arraySize(const Json& document, const std::string& name) {
  const std::size_t dot = name.find('.');
  const Json::json_pointer pointer(
      dot == std::string::npos ? "/" + name : "/extensions/" + name.substr(0, dot) + "/" + name.substr(dot + 1));
  if (!document.contains(pointer)) return 0;
  const Json& array = document[pointer];
  return array.is_array() ? array.size() : 0;
}

std::int64_t checkedIndex(const Json& value, const Place& at) {
  if (!value.is_number()) refuse(at.path + " is not an index");
  const double v = value.get<double>();
  const std::size_t count = arraySize(at.document, at.property.array);
  if (v != std::floor(v) || v < 0 || v >= static_cast<double>(count))
    refuse(at.path + " is " + number(v) + "; there are " + std::to_string(count) + " " + at.property.array);
  return static_cast<std::int64_t>(v);
}

void checkItems(const Json& value, const Place& at) {
  if (!value.is_array()) refuse(at.path + " is not an array");
  const Property& p = at.property;
  if (value.size() >= p.minItems && value.size() <= p.maxItems) return;
  const std::string wanted =
      p.minItems == p.maxItems ? std::to_string(p.minItems) : "at most " + std::to_string(p.maxItems);
  refuse(at.path + " has " + std::to_string(value.size()) + " elements; " + wanted + " are expected");
}

constexpr const char* kBroken = "broken values";
constexpr const char* kAbsent = "each is as if it were not there";

/// Indices of a list that point nowhere are left out.
Json checkedIndices(const Json& value, const Place& at) {
  checkItems(value, at);
  Json out = Json::array();
  for (std::size_t i = 0; i < value.size(); ++i) {
    try {
      out.push_back(checkedIndex(value[i], Place{at.property, at.document, element(at.path, i), at.warnings}));
    } catch (const Refusal& refusal) {
      at.warnings.count(kBroken, refusal.reason, kAbsent);
    }
  }
  return out;
}

Json checkedObjects(const Json& value, const Place& at) {
  checkItems(value, at);
  Json out = Json::array();
  out.get_ref<Json::array_t&>().reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    try {
      out.push_back(checked(value[i], *at.property.object, at.document, element(at.path, i), at.warnings));
    } catch (const Refusal& refusal) {
      if (!at.property.standIn) throw;
      at.warnings.count(std::string("broken ") + at.property.key, refusal.reason, kEachLeftOut);
      if (*at.property.standIn) out.push_back(Json::parse(at.property.standIn));
    }
  }
  return out;
}

template <class Check>
Json checkedArray(const Json& value, const Place& at, Check&& check) {
  checkItems(value, at);
  Json out = Json::array();
  out.get_ref<Json::array_t&>().reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i)
    out.push_back(check(value[i], Place{at.property, at.document, element(at.path, i), at.warnings}));
  return out;
}

Json checkedString(const Json& value, const Place& at) {
  if (!value.is_string()) refuse(at.path + " is not a string");
  checkChoice(at, value.get_ref<const std::string&>());
  return value;
}

Json checkedAttributes(const Json& value, const Place& at) {
  if (!value.is_object()) refuse(at.path + " is not an object");
  Json out = Json::object();
  for (const auto& [key, index] : value.items())
    out[key] = checkedIndex(index, Place{at.property, at.document, at.path + "." + oneLine(key), at.warnings});
  return out;
}

Json checkedValue(const Json& value, const Place& at) {
  switch (at.property.kind) {
    case Kind::kAny: return value;
    case Kind::kBoolean:
      if (!value.is_boolean()) refuse(at.path + " is not true or false");
      return value;
    case Kind::kString: return checkedString(value, at);
    case Kind::kNumber: return checkedNumber(value, at);
    case Kind::kInteger: return checkedInteger(value, at);
    case Kind::kIndex: return checkedIndex(value, at);
    case Kind::kNumbers: return checkedArray(value, at, checkedNumber);
    case Kind::kIndices: return checkedIndices(value, at);
    case Kind::kStrings: return checkedArray(value, at, checkedString);
    case Kind::kAttributes: return checkedAttributes(value, at);
    case Kind::kObject: return checked(value, *at.property.object, at.document, at.path, at.warnings);
    case Kind::kObjects: return checkedObjects(value, at);
  }
  return {};
}

}  // namespace

Json checked(const Json& value, const Schema& schema, const Json& document, const std::string& path,
             Warnings& warnings) {
  if (!value.is_object()) refuse((path.empty() ? "its JSON" : path) + " is not an object");
  Json out = Json::object();
  for (const Property& property : schema.properties) {
    const std::string where = path.empty() ? property.key : path + "." + property.key;
    const auto found = value.find(property.key);
    if (found != value.end() && property.free && !found->is_object()) continue;
    if (found == value.end()) {
      if (property.required) refuse(where + " is missing");
      continue;
    }
    try {
      out[property.key] = checkedValue(*found, Place{property, document, where, warnings});
    } catch (const Refusal& refusal) {
      if (property.required) throw;
      warnings.count(kBroken, refusal.reason, kAbsent);
    }
  }
  return out;
}

}  // namespace tyndall::scene
