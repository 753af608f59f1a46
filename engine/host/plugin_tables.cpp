#include "plugin_tables.hpp"

#include <cmath>
#include <set>

namespace tyndall::host {
namespace {

bool onlyFrom(const std::string& text, const char* extra) {
  for (const char c : text)
    if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || std::strchr(extra, c) != nullptr)) return false;
  return !text.empty();
}

std::string versionText(std::uint32_t version) {
  return std::to_string(TY_ABI_MAJOR_OF(version)) + "." + std::to_string(TY_ABI_MINOR_OF(version));
}

Result<void> readChoices(const TyParameter& row, params::Parameter& p) {
  if (row.choice_count < 1 || row.choice_count > 64 || row.choices == nullptr)
    return failed(p.id + ": an enum has 1 to 64 choices; this one has " +
                  std::to_string(row.choices ? row.choice_count : 0));
  std::set<std::string> seen;
  for (std::uint32_t i = 0; i < row.choice_count; ++i) {
    auto choice = readName(row.choices[i], p.id + ": choice " + std::to_string(i));
    if (!choice) return choice.error();
    if (!seen.insert(*choice).second)
      return failed(p.id + ": the choice '" + *choice + "' appears twice; choices are unique");
    p.choices.push_back(choice.take());
    p.built.push_back((row.unbuilt >> i & 1) == 0);
  }
  return {};
}

Result<void> readRange(const TyParameter& row, params::Parameter& p) {
  for (const double number : {row.min_value, row.max_value, row.built_min, row.built_max}) {
    if (!std::isfinite(number)) return failed(p.id + ": a limit is not a finite number; every limit must be");
    if (p.type == params::Type::kInt && (number != std::floor(number) || std::abs(number) > 9007199254740992.0))
      return failed(p.id + ": a limit of this whole-number parameter is not a whole number within 2^53");
  }
  if (row.min_value > row.max_value) return failed(p.id + ": its smallest value is above its largest; swap them");
  p.min = p.builtMin = row.min_value;
  p.max = p.builtMax = row.max_value;
  if (row.built_min < row.built_max || (row.unbuilt & 1) != 0) {
    p.builtMin = std::max(p.min, row.built_min);
    p.builtMax = std::min(p.max, row.built_max);
  }
  return {};
}

/// Marks the selector's choices that no technique has as not built.
Result<void> joinTechniques(PluginTables& tables) {
  if (tables.selector == TY_NONE) return {};
  if (tables.selector >= tables.parameters.size())
    return failed("techniques: the selector is parameter " + std::to_string(tables.selector) + ", but there are " +
                  std::to_string(tables.parameters.size()));
  params::Parameter& p = tables.parameters[tables.selector];
  if (p.type != params::Type::kEnum) return failed(p.id + ": chooses the technique, so it must be an enum");
  std::set<std::string> built = {"none"};
  for (const TechniqueInfo& t : tables.techniques) {
    built.insert(t.id);
    if (std::find(p.choices.begin(), p.choices.end(), t.id) == p.choices.end())
      return failed(p.id + ": the technique '" + t.id + "' is not among its choices; add it");
  }
  for (std::size_t i = 0; i < p.choices.size(); ++i)
    if (!built.contains(p.choices[i])) p.built[i] = false;
  return {};
}

}  // namespace

Result<void> checkAbiVersion(std::uint32_t plugin, std::uint32_t host) {
  const bool fits =
      TY_ABI_MAJOR_OF(plugin) == TY_ABI_MAJOR_OF(host) && TY_ABI_MINOR_OF(plugin) <= TY_ABI_MINOR_OF(host);
  if (fits) return {};
  return failed("was built for plugin ABI " + versionText(plugin) + "; this program takes " + versionText(host) +
                (TY_ABI_MINOR_OF(host) > 0 ? " and older ones of the same major version" : "") +
                ", so rebuild one of them");
}

Result<std::string> readText(const char* text, const std::string& what) {
  if (text == nullptr) return failed(what + ": is null; a string is needed");
  constexpr std::size_t kLongest = 4096;
  const std::size_t length = ::strnlen(text, kLongest + 1);
  if (length > kLongest) return failed(what + ": is longer than " + std::to_string(kLongest) + " bytes");
  std::string copy(text, length);
  for (char& c : copy)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return copy;
}

Result<std::string> readName(const char* text, const std::string& what) {
  auto name = readText(text, what);
  if (!name) return name;
  if (name->empty()) return failed(what + ": is empty; a name is needed");
  if (name->size() > 128) return failed(what + ": is longer than 128 bytes");
  return name;
}

Result<TyPlugin> readPlugin(const void* entry) {
  std::uint32_t version = 0;
  std::memcpy(&version, entry, sizeof version);
  if (auto fits = checkAbiVersion(version); !fits) return fits.error();
  const auto plugin = readStruct<TyPlugin>(entry, offsetof(TyPlugin, struct_size));
  auto id = readName(plugin.id, "the plugin's id");
  if (!id) return id.error();
  if (!onlyFrom(*id, "_")) return failed("the plugin's id '" + *id + "' is not made of a-z, 0-9 and _ alone");
  for (const auto& [text, what] : {std::pair{plugin.name, "name"}, {plugin.version, "version"}, {plugin.doc, "doc"}})
    if (auto read = readText(text, std::string("the plugin's ") + what); !read) return read.error();
  const std::pair<bool, const char*> functions[] = {
      {plugin.init != nullptr, "init"},     {plugin.shutdown != nullptr, "shutdown"},
      {plugin.create != nullptr, "create"}, {plugin.destroy != nullptr, "destroy"},
      {plugin.layout != nullptr, "layout"}, {plugin.prepare != nullptr, "prepare"}};
  for (const auto& [there, name] : functions)
    if (!there) return failed(std::string("the function '") + name + "' is missing; a plugin has to give it");
  return plugin;
}

Result<params::Parameter> readParameter(const TyParameter& row, const std::string& owner) {
  params::Parameter p;
  p.owner = owner;
  auto id = readName(row.id, "the id of a parameter");
  if (!id) return id.error();
  p.id = id.take();
  const auto dot = p.id.find('.');
  if (!onlyFrom(p.id, "_.") || dot == std::string::npos || dot == 0 || dot + 1 == p.id.size())
    return failed("the parameter id '" + p.id + "' is not of the form group.name made of a-z, 0-9 and _");
  for (const auto& [from, to, what] :
       {std::tuple{row.name, &p.name, ": name"}, {row.unit, &p.unit, ": unit"}, {row.doc, &p.doc, ": doc"}}) {
    auto text = readText(from, p.id + what);
    if (!text) return text.error();
    *to = text.take();
  }
  p.structural = (row.flags & TY_PARAMETER_STRUCTURAL) != 0;
  p.logarithmic = (row.flags & TY_PARAMETER_LOGARITHMIC) != 0;
  p.defaultValue = row.default_value;
  switch (row.type) {
    case TY_PARAMETER_BOOL:
      p.type = params::Type::kBool;
      p.built = {(row.unbuilt & 1) == 0, (row.unbuilt & 2) == 0};
      break;
    case TY_PARAMETER_INT: p.type = params::Type::kInt; break;
    case TY_PARAMETER_FLOAT: p.type = params::Type::kFloat; break;
    case TY_PARAMETER_ENUM: p.type = params::Type::kEnum; break;
    default: return failed(p.id + ": its type " + std::to_string(row.type) + " is unknown; types are 0 to 3");
  }
  const bool numeric = p.type == params::Type::kInt || p.type == params::Type::kFloat;
  if (numeric)
    if (auto range = readRange(row, p); !range) return range.error();
  if (p.type == params::Type::kEnum)
    if (auto choices = readChoices(row, p); !choices) return choices.error();
  return p;
}

Result<PluginTables> readTables(const TyPlugin& plugin) {
  PluginTables tables;
  std::uint32_t count = 0;
  if (plugin.parameters != nullptr) {
    const TyParameter* rows = plugin.parameters(&count);
    auto read = readArray(rows, count, "parameters");
    if (!read) return read.error();
    std::set<std::string> ids;
    for (const TyParameter& row : *read) {
      auto p = readParameter(row, plugin.id);
      if (!p) return p.error();
      if (!ids.insert(p->id).second) return failed(p->id + ": appears twice in the parameter table; ids are unique");
      tables.parameters.push_back(p.take());
    }
  }
  if (plugin.techniques != nullptr) {
    count = 0;
    const TyTechnique* rows = plugin.techniques(&count, &tables.selector);
    auto read = readArray(rows, count, "techniques");
    if (!read) return read.error();
    for (const TyTechnique& row : *read) {
      TechniqueInfo info;
      for (const auto& [from, to, what] :
           {std::tuple{row.id, &info.id, "id"}, {row.name, &info.name, "name"}, {row.doc, &info.doc, "doc"}}) {
        auto text = readText(from, std::string("the ") + what + " of a technique");
        if (!text) return text.error();
        *to = text.take();
      }
      if (info.id.empty()) return failed("a technique has no id; every technique needs one");
      if (row.read_count > kMostElements || (row.read_count > 0 && row.reads == nullptr))
        return failed("technique '" + info.id + "': the list of parameters it reads is null or too long");
      for (std::uint32_t i = 0; i < row.read_count; ++i) {
        auto id = readName(row.reads[i], "technique '" + info.id + "': a parameter it reads");
        if (!id) return id.error();
        info.reads.push_back(id.take());
      }
      tables.techniques.push_back(std::move(info));
    }
  }
  if (auto joined = joinTechniques(tables); !joined) return joined.error();
  // Last, because a technique that is not there makes its choice unusable as a default.
  for (const params::Parameter& p : tables.parameters)
    if (auto usable = params::check(p, p.defaultValue); !usable)
      return failed("the default of " + usable.error().message);
  return tables;
}

}  // namespace tyndall::host
