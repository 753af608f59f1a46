#include "app/presets.hpp"

#include <algorithm>
#include <vector>

#include "base/file.hpp"

namespace tyndall::app {

std::filesystem::path presetFolder() { return executableFolder() / "presets"; }

Result<std::filesystem::path> findPreset(const std::filesystem::path& asked) {
  const std::string text = asked.string();
  if (text.find('/') != std::string::npos || text.ends_with(".json")) return asked;
  const std::filesystem::path folder = presetFolder();
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  if (std::find(names.begin(), names.end(), text) != names.end()) return folder / (text + ".json");
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  const std::string near = nearestName(text, names);
  if (names.empty())
    return badCall("--preset '" + text + "': there are no presets in " + folder.string() +
                   ", where the programs' own are expected; a path ending in .json would be right");
  return badCall("--preset '" + text + "': no such preset" + (near.empty() ? "" : ", did you mean '" + near + "'?") +
                 "; there are " + list + ", or give a path ending in .json");
}

}  // namespace tyndall::app
