#include "params/table.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "registry.hpp"

namespace volumetrics {
namespace {

/// The names of "a|b|c" as zero-terminated strings that live as long as the library.
struct Choices {
  std::vector<std::string> names;
  std::vector<const char*> pointers;

  explicit Choices(std::string_view joined) {
    while (!joined.empty()) {
      const std::size_t bar = joined.find('|');
      names.emplace_back(joined.substr(0, bar));
      joined = bar == std::string_view::npos ? std::string_view{} : joined.substr(bar + 1);
    }
    for (const std::string& name : names) pointers.push_back(name.c_str());
  }

  /// A name that a row misspells is a mistake of the plugin's: the index is out of range, which the host refuses.
  std::uint32_t indexOf(std::string_view name) const {
    return static_cast<std::uint32_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
};

TyParameter plain(TyParameterType type, const char* id, const char* label, double standard, const char* unit,
                  std::uint32_t flags, const char* doc) {
  TyParameter parameter{};
  parameter.struct_size = sizeof(TyParameter);
  parameter.type = type;
  parameter.id = id;
  parameter.name = label;
  parameter.unit = unit;
  parameter.doc = doc;
  parameter.default_value = standard;
  parameter.flags = flags;
  return parameter;
}

TyParameter number(TyParameter parameter, double low, double high, double builtLow, double builtHigh) {
  parameter.min_value = low;
  parameter.max_value = high;
  parameter.built_min = builtLow;
  parameter.built_max = builtHigh;
  parameter.unbuilt = builtLow > low || builtHigh < high ? 1 : 0;
  return parameter;
}

TyParameter choice(TyParameter parameter, const Choices& choices, std::string_view standard, const Choices& unbuilt) {
  parameter.choices = choices.pointers.data();
  parameter.choice_count = static_cast<std::uint32_t>(choices.pointers.size());
  parameter.max_value = parameter.choice_count - 1;
  parameter.default_value = choices.indexOf(standard);
  for (const std::string& name : unbuilt.names) parameter.unbuilt |= 1ull << choices.indexOf(name);
  return parameter;
}

TyParameter flag(TyParameter parameter, std::uint64_t unbuilt) {
  parameter.max_value = 1;
  parameter.unbuilt = unbuilt;
  return parameter;
}

#define ROW_INT(field, id, label, standard, low, high, builtLow, builtHigh, unit, flags, doc) \
  rows.push_back(                                                                             \
      number(plain(TY_PARAMETER_INT, id, label, standard, unit, flags, doc), low, high, builtLow, builtHigh));
#define ROW_FLOAT(field, id, label, standard, low, high, unit, flags, doc) \
  rows.push_back(number(plain(TY_PARAMETER_FLOAT, id, label, standard, unit, flags, doc), low, high, low, high));
#define ROW_ENUM(field, id, label, standard, unbuilt, choices, flags, doc)                                             \
  {                                                                                                                    \
    static const Choices names(choices);                                                                               \
    rows.push_back(choice(plain(TY_PARAMETER_ENUM, id, label, 0, "", flags, doc), names, standard, Choices(unbuilt))); \
  }
#define ROW_BOOL(field, id, label, standard, unbuilt, flags, doc) \
  rows.push_back(flag(plain(TY_PARAMETER_BOOL, id, label, standard, "", flags, doc), unbuilt));

std::vector<TyParameter> makeTable() {
  std::vector<TyParameter> rows;
  TY_ALL_PARAMS(ROW_INT, ROW_FLOAT, ROW_ENUM, ROW_BOOL)
  for (TyParameter& row : rows) {
    if (std::strcmp(row.id, "volumetrics.technique") != 0) continue;
    for (std::uint32_t i = 0; i < row.choice_count; ++i)
      if (std::strcmp(row.choices[i], "none") != 0 && findTechnique(row.choices[i]) == nullptr)
        row.unbuilt |= 1ull << i;
  }
  return rows;
}

std::uint32_t indexOf(std::string_view id) {
  const auto table = parameterTable();
  for (std::uint32_t i = 0; i < table.size(); ++i)
    if (table[i].id == id) return i;
  return TY_NONE;
}

}  // namespace

std::span<const TyParameter> parameterTable() {
  static const std::vector<TyParameter> table = makeTable();
  return table;
}

std::uint32_t techniqueIndex() { return indexOf("volumetrics.technique"); }
std::uint32_t prefixSchemeIndex() { return indexOf("volumetrics.prefix_scheme"); }

Settings readSettings(const double* values, std::uint32_t count) {
  Settings settings{};
  const auto table = parameterTable();
  std::uint32_t i = 0;
  const auto next = [&] {
    const double value = i < count ? values[i] : table[i].default_value;
    ++i;
    return value;
  };
#define READ_INT(field, ...) settings.field = static_cast<int>(next());
#define READ_FLOAT(field, ...) settings.field = static_cast<float>(next());
  TY_ALL_PARAMS(READ_INT, READ_FLOAT, READ_INT, READ_INT)
  return settings;
}

}  // namespace volumetrics
