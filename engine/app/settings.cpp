#include "settings.hpp"

#include "app/presets.hpp"

#include <cstdio>

#include "base/file.hpp"

namespace tyndall::app {

Result<std::unique_ptr<Catalogue>> loadSettings(const SettingsOptions& options) {
  auto catalogue = Catalogue::load(pluginFolder(options.pluginFolder));
  if (!catalogue) return catalogue;
  params::Table& table = (*catalogue)->table();
  if (!options.preset.empty()) {
    auto file = findPreset(options.preset);
    if (!file) return file.error();
    auto text = readText(*file, 1u << 20);  // a preset is a page of text; 1 MiB is generous
    if (!text) return Error{"--preset " + text.error().message, text.error().kind};
    if (auto read = table.readPreset(*text, file->string()); !read)
      return Error{"--preset " + read.error().message, read.error().kind};
  }
  for (const std::string& assignment : options.assignments)
    if (auto set = table.setAssignment(assignment); !set)
      return Error{"--set " + set.error().message, set.error().kind};
  return catalogue;
}

void tell(const std::vector<std::string>& warnings, const std::vector<std::string>& notes) {
  for (const std::string& line : warnings) std::fprintf(stderr, "tyndall: warning: %s\n", oneLine(line).c_str());
  for (const std::string& line : notes) std::fprintf(stderr, "tyndall: note: %s\n", oneLine(line).c_str());
}

std::string oneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

}  // namespace tyndall::app
