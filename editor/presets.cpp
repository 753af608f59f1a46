#include "presets.hpp"

#include "base/file.hpp"

namespace tyndall::editor {
namespace {

/// A table of the same parameters with the file's values.
Result<params::Table> tableOf(const params::Table& table, const std::filesystem::path& file) {
  auto text = readText(file, 1u << 20);  // a preset is a page of text; 1 MiB is generous
  if (!text) return text.error();
  params::Table other;
  if (auto added = other.add({table.parameters().begin(), table.parameters().end()}); !added) return added.error();
  if (auto read = other.readPreset(*text, file.string()); !read) return read.error();
  return other;
}

}  // namespace

Result<void> loadPreset(params::Table& table, const std::filesystem::path& file) {
  auto other = tableOf(table, file);
  if (!other) return other.error();
  for (const std::string& id : other->assigned())
    if (auto set = table.set(id, other->value(id)); !set) return set;
  return {};
}

Result<void> savePreset(const params::Table& table, const std::filesystem::path& file) {
  return writeTextAtomically(file, table.writePreset(false));
}

Result<std::vector<Difference>> comparePreset(const params::Table& table, const std::filesystem::path& file) {
  auto other = tableOf(table, file);
  if (!other) return other.error();
  std::vector<Difference> differences;
  for (const params::Parameter& parameter : table.parameters()) {
    if (!other->isAssigned(parameter.id)) continue;
    const double here = table.value(parameter.id), there = other->value(parameter.id);
    if (here != there)
      differences.push_back({parameter.id, params::toText(parameter, here), params::toText(parameter, there)});
  }
  return differences;
}

}  // namespace tyndall::editor
