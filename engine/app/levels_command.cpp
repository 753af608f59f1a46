#include "app/level.hpp"
#include "app/print.hpp"
#include "commands.hpp"
#include "settings.hpp"

namespace tyndall::app {

Result<void> runLevels(const LevelsOptions&) {
  std::string text;
  for (const std::string& name : sampleLevels()) text += name + "\n";
  if (text.empty()) return failed(levelFolder().string() + ": no sample level; build the target tyndall_sample_levels");
  return print(text);
}

}  // namespace tyndall::app
