#include "history.hpp"

#include <set>

namespace tyndall::editor {
namespace {

// A step of a few changed settings is about a kilobyte: enough for a day's work in some tens of megabytes.
constexpr std::size_t kMaxSteps = 20000;

std::string shown(const params::Table& table, const std::map<std::string, std::string>& settings,
                  const std::string& id) {
  const auto found = settings.find(id);
  if (found != settings.end()) return found->second;
  const params::Parameter* parameter = table.find(id);
  return parameter ? params::toText(*parameter, parameter->defaultValue) : "default";
}

std::string labelOf(const params::Table& table, const EditState& before, const EditState& after) {
  std::set<std::string> ids, changed;
  for (const auto* settings : {&before.settings, &after.settings})
    for (const auto& [id, text] : *settings) ids.insert(id);
  for (const std::string& id : ids)
    if (shown(table, before.settings, id) != shown(table, after.settings, id)) changed.insert(id);
  std::string label;
  const auto add = [&label](const std::string& text) { label += (label.empty() ? "" : ", ") + text; };
  if (changed.size() == 1) {
    const params::Parameter* parameter = table.find(*changed.begin());
    add((parameter ? parameter->name : *changed.begin()) + " " + shown(table, before.settings, *changed.begin()) +
        " -> " + shown(table, after.settings, *changed.begin()));
  } else if (!changed.empty()) {
    add(std::to_string(changed.size()) + " settings");
  }
  if (before.scene.lights != after.scene.lights) add("light");
  if (before.scene.nodes != after.scene.nodes) add("place");
  if (before.scene.materials != after.scene.materials) add("material");
  if (before.camera != after.camera)
    add("camera " + std::to_string(after.camera));
  else if (before.pose != after.pose)
    add(after.pose ? "camera" : "camera to the file's");
  return label.empty() ? "default values"
                       : label;  // a value that was set to its default is set no longer, or the reverse
}

}  // namespace

std::map<std::string, std::string> settingsOf(const params::Table& table) {
  std::map<std::string, std::string> settings;
  for (const std::string& id : table.assigned()) settings[id] = params::toText(*table.find(id), table.value(id));
  return settings;
}

std::vector<std::string> applySettings(params::Table& table, const std::map<std::string, std::string>& settings) {
  table.resetToDefaults();
  std::vector<std::string> refused;
  for (const auto& [id, text] : settings)
    if (auto set = table.setText(id, text); !set) refused.push_back(set.error().message);
  return refused;
}

bool History::observe(const params::Table& table, const EditState& now, bool busy) {
  if (steps_.empty()) {
    steps_.push_back({"start", std::make_shared<const EditState>(now)});
    present_ = 0;
    return false;
  }
  const EditState& last = *steps_[present_].after;
  if (busy || now == last) return false;
  std::string label = labelOf(table, last, now);
  steps_.resize(present_ + 1);
  steps_.push_back({std::move(label), std::make_shared<const EditState>(now)});
  if (steps_.size() > kMaxSteps) steps_.erase(steps_.begin());
  present_ = steps_.size() - 1;
  return true;
}

void History::clear() {
  steps_.clear();
  present_ = 0;
}

const EditState* History::jump(std::size_t step) {
  if (step >= steps_.size()) return nullptr;
  present_ = step;
  return steps_[step].after.get();
}

}  // namespace tyndall::editor
