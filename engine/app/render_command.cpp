// tyndall render: everything that can be wrong with the call is checked before the first frame; files are written after
// the last, all or none.
#include "app/haze.hpp"
#include "app/level.hpp"
#include "app/outputs.hpp"
#include "app/print.hpp"
#include "app/values.hpp"
#include "commands.hpp"
#include "render_files.hpp"
#include "render_run.hpp"
#include "settings.hpp"
#include "stats.hpp"

namespace tyndall::app {

Result<void> runRender(const RenderOptions& options) {
  auto path = findLevel(options.level);
  if (!path) return path.error();
  Outputs outputs;
  if (auto added = addRenderFiles(outputs, options, *path); !added) return added;
  auto catalogue = loadSettings(options.settings);
  if (!catalogue) return catalogue.error();
  auto level = loadLevel(options.level);
  if (!level) return level.error();
  auto camera = chooseCamera(*level, options.camera, options.seconds);
  if (!camera) return camera.error();
  if (options.pose) *camera = placed(*camera, *options.pose);
  std::vector<std::string> warnings = (*catalogue)->warnings(), notes = level->notes;
  warnings.insert(warnings.end(), level->warnings.begin(), level->warnings.end());

  gpu::DeviceOptions device;
  device.name = options.device;
  device.validation = options.validate;
  auto opened = Session::open(catalogue.take(), device);
  if (!opened) return opened.error();
  Session& session = **opened;
  if (auto fits = checkSize("--size", options.size, session.maxSide(), session.device().info().name + " takes"); !fits)
    return fits;
  if (auto set = session.setLevel(level.take()); !set) return set;
  auto run = renderFrames(session, options, *camera);
  if (!run) return run.error();
  if (run->validationMessages > 0)
    return failed("--validate: the validation layer gave " + std::to_string(run->validationMessages) +
                  " messages (above); none is right");
  notes.insert(notes.end(), session.renderer().notes().begin(), session.renderer().notes().end());
  if (const auto haze = hidingHaze(session)) notes.push_back(haze->line);

  std::vector<std::string> told = warnings;
  told.insert(told.end(), notes.begin(), notes.end());
  std::string text = statsTable(options, session, *run);
  for (const std::filesystem::path& file : outputs.paths()) text += file.string() + "\n";
  auto written =
      writeRenderFiles(outputs, *run, statsJson(options, session, *run, told), [&text] { return print(text); });
  if (!written) return written;
  tell(warnings, notes);
  return {};
}

}  // namespace tyndall::app
