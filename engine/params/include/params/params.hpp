// Parameter tables and their values: one table makes the command line, the presets, the editor's widgets and the
// documentation. Holds the engine's own parameters and, behind the same interface, every loaded plugin's.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace tyndall::params {

enum class Type { kBool, kInt, kFloat, kEnum };

/// One parameter. Values are held as double whatever the type (bool 0/1, enum = index of the choice): exact up to 2^53.
struct Parameter {
  std::string id;    ///< "volumetrics.steps"; the part before the dot is the group
  std::string name;  ///< "Steps"
  std::string unit;  ///< "1/m", "" if none
  std::string doc;   ///< one or two sentences
  Type type = Type::kFloat;
  double defaultValue = 0;
  double min = 0, max = 1;            ///< inclusive, for kInt and kFloat
  double builtMin = 0, builtMax = 1;  ///< values outside this but inside [min, max] are refused as "not built yet"
  std::vector<std::string> choices;   ///< for kEnum
  std::vector<bool> built;            ///< per choice (kEnum), or {false built, true built} (kBool); empty: all
  bool structural = false;            ///< a change needs a new layout
  bool logarithmic = false;           ///< for the editor's slider
  std::string owner;                  ///< "engine" or the plugin's id
};

/// A value as text: "true", "17", "0.03", "moments6".
std::string toText(const Parameter& parameter, double value);

/// Reads text for `parameter`. Refusals (all ErrorKind::kBadCall, one line that names the id): not a number, outside
/// the range (says the range), no such choice (says the choices and the nearest), a value that is not built yet.
Result<double> fromText(const Parameter& parameter, std::string_view text);
/// The same checks for a number that comes from an editor or a preset.
Result<double> check(const Parameter& parameter, double value);

/// All parameters in order of registration, with their values.
class Table {
 public:
  /// Adds parameters; ids must be new (a duplicate is a failed Result naming it).
  Result<void> add(std::vector<Parameter> parameters);
  /// Removes every parameter of `owner`; values that were set or differ from their default are remembered (as text: an
  /// enum's choices may be renumbered) and come back when the same ids are added again, so that a reloaded plugin keeps
  /// its values; one that no longer passes the checks becomes the default, with a log line.
  void remove(std::string_view owner);

  std::span<const Parameter> parameters() const { return parameters_; }
  const Parameter* find(std::string_view id) const;
  double value(std::string_view id) const;     ///< asserts that the id exists
  bool changed(std::string_view id) const;     ///< differs from the default
  bool isAssigned(std::string_view id) const;  ///< was set explicitly, be it to its default; asserts that the id exists
  Result<void> set(std::string_view id, double value);
  void reset(std::string_view id);  ///< to the default, as if it had never been set; asserts that the id exists
  /// "id=value" or separate id and text; an unknown id is answered with the nearest valid name.
  Result<void> setText(std::string_view id, std::string_view text);
  Result<void> setAssignment(std::string_view assignment);
  void resetToDefaults();
  /// Ids set explicitly (by setText/set), for "unused" reports.
  std::vector<std::string> assigned() const;

  /// Preset: a JSON object {"id": value, ...}, also nested under "settings"; numbers, booleans and strings. An object
  /// "evidence" beside them, which says where the values come from, is passed over. All or nothing: on an error no
  /// value changes. `source` names the file in errors. Malformed JSON is ErrorKind::kFailed; an unknown or repeated id
  /// or a refused value is kBadCall.
  Result<void> readPreset(std::string_view json, std::string_view source);
  std::string writePreset(bool changedOnly) const;

 private:
  struct Remembered {
    std::string text;
    bool assigned = false;
  };
  std::optional<std::size_t> indexOf(std::string_view id) const;
  Error unknownId(std::string_view id) const;

  std::vector<Parameter> parameters_;
  std::vector<double> values_;
  std::vector<bool> assigned_;
  std::map<std::string, std::size_t, std::less<>> index_;  ///< id -> place in the vectors above
  std::map<std::string, Remembered, std::less<>> remembered_;
};

/// The engine's own: shadows.mode, shadows.resolution, shadows.precision, shadows.reuse, sky.strength, view.exposure,
/// view.auto_exposure.
std::vector<Parameter> engineParameters();

}  // namespace tyndall::params
