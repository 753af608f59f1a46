#include "app/capture.hpp"

#include <charconv>

#include "base/file.hpp"
#include "render_files.hpp"
#include "stats.hpp"

namespace tyndall::app {
namespace {

std::string number(double value) {
  char digits[32];  // the shortest text that reads back to the same double
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  return {digits, end.ptr};
}

RenderOptions optionsOf(const Capture& capture) {
  RenderOptions options;
  options.level = capture.level, options.camera = capture.camera, options.pose = capture.pose;
  options.size = capture.size, options.seconds = capture.seconds, options.debugView = capture.debugView;
  options.picture = capture.picture, options.scatter = capture.scatter, options.depth = capture.depth,
  options.stats = capture.stats, options.viewExr = capture.viewExr;
  return options;
}

}  // namespace

Result<void> capture(Session& session, const Capture& capture) {
  const RenderOptions options = optionsOf(capture);
  auto camera = chooseCamera(*session.level(), options.camera, options.seconds);
  if (!camera) return camera.error();
  if (options.pose) *camera = placed(*camera, *options.pose);
  Outputs outputs;
  if (auto added = addRenderFiles(outputs, options, session.level()->path); !added) return added;
  session.restart();
  auto run = renderFrames(session, options, *camera);
  if (!run) return run.error();
  std::vector<std::string> notes = session.catalogue().warnings();
  for (const auto* more : {&session.level()->warnings, &session.level()->notes, &session.renderer().notes()})
    notes.insert(notes.end(), more->begin(), more->end());
  return writeRenderFiles(outputs, *run, statsJson(options, session, *run, notes));
}

std::vector<std::string> captureWords(Session& session, const Capture& capture) {
  std::vector<std::string> words{"tyndall", "render", capture.level};
  const auto add = [&words](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  if (capture.camera > 0) add("--camera", std::to_string(capture.camera));
  if (capture.pose) add("--pose", poseText(*capture.pose));
  add("--size", std::to_string(capture.size.first) + "x" + std::to_string(capture.size.second));
  if (capture.seconds != 0) add("--time", number(capture.seconds));
  for (const params::Parameter& parameter : session.table().parameters())
    if (session.table().changed(parameter.id))
      add("--set", parameter.id + "=" + params::toText(parameter, session.table().value(parameter.id)));
  add("--debug-view", capture.debugView), add("--view-exr", capture.viewExr);
  add("--device", session.device().info().name);
  // Another folder than the program's own, whether an option or the environment named it.
  const std::filesystem::path plugins = pluginFolder(capture.pluginFolder);
  std::error_code unknown;
  if (plugins != executableFolder() / "plugins")
    add("--plugin-dir", std::filesystem::absolute(plugins, unknown).string());
  add("--out", capture.picture), add("--scatter", capture.scatter), add("--depth", capture.depth),
      add("--stats", capture.stats);
  return words;
}

std::string shellLine(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    const bool plain =
        !word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%") ==
            std::string::npos;
    line += line.empty() ? "" : " ";
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace tyndall::app
