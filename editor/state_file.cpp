#include "state_file.hpp"

#include <nlohmann/json.hpp>

#include "base/file.hpp"

namespace tyndall::editor {

Result<void> StateFile::update(const Snapshot& now) {
  if (path_.empty()) return {};
  using Json = nlohmann::ordered_json;
  const auto vector = [](const glm::vec4& v) { return Json::array({v.x, v.y, v.z}); };
  const glm::mat4& pose = now.view.worldFromView;
  Json json;
  json["level"] = now.session.level()->name;
  json["device"] = now.session.device().info().name;
  json["frames"] = now.frames;
  json["pictures"] = now.pictures;
  json["seconds"] = now.workspace.seconds;
  json["playing"] = now.workspace.playing;
  json["debug_view"] = now.workspace.debugView;
  json["message"] = now.workspace.message;
  json["camera"] = {{"index", now.cameraIndex},
                    {"flown", now.camera.flown()},
                    {"position", vector(pose[3])},
                    {"forward", vector(-pose[2])},
                    {"speed", now.camera.speed()}};
  json["history"] = {{"steps", now.history.steps().size()}, {"present", now.history.present()}};
  if (!now.history.steps().empty()) json["history"]["label"] = now.history.steps()[now.history.present()].label;
  const params::Table& table = now.session.table();
  for (const params::Parameter& parameter : table.parameters())
    json["settings"][parameter.id] = params::toText(parameter, table.value(parameter.id));
  for (const auto& [name, value] : now.workspace.facts) json["facts"][name] = value;
  for (const auto& [name, rect] : now.workspace.widgets)
    json["widgets"][name] = {rect.x, rect.y, rect.width, rect.height};
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (text == written_) return {};
  if (auto done = writeTextAtomically(path_, text); !done)
    return Error{"--print-state " + done.error().message, done.error().kind};
  written_ = std::move(text);
  return {};
}

}  // namespace tyndall::editor
