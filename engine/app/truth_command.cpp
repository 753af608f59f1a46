// tyndall truth: the ray-traced reference. No GPU; the plugin is loaded for its parameter table only.
#include "app/level.hpp"
#include "app/outputs.hpp"
#include "app/print.hpp"
#include "app/values.hpp"
#include "commands.hpp"
#include "settings.hpp"

#include "image/image_io.hpp"
#include "truth/truth.hpp"

namespace tyndall::app {
namespace {

image::FloatImage scatterImage(const truth::Picture& picture) {
  image::FloatImage result{picture.width, picture.height, 4, {}};
  result.values.reserve(picture.scatter.size() * 4);
  for (const glm::vec4& pixel : picture.scatter)
    result.values.insert(result.values.end(), {pixel.r, pixel.g, pixel.b, pixel.a});
  return result;
}

}  // namespace

Result<void> runTruth(const TruthOptions& options) {
  using Path = std::filesystem::path;
  auto path = findLevel(options.level);
  if (!path) return path.error();
  Outputs outputs;
  outputs.protect(*path);
  if (!options.settings.preset.empty()) outputs.protect(options.settings.preset);
  if (auto added = outputs.add("--out", options.scatter, ".exr"); !added) return added;
  if (!options.depth.empty())
    if (auto added = outputs.add("--depth", options.depth, ".exr"); !added) return added;
  // No device has a say here; picture files do.
  if (auto fits = checkSize("--size", options.size, image::kMaxSide, "picture files take"); !fits) return fits;
  auto catalogue = loadSettings(options.settings);
  if (!catalogue) return catalogue.error();
  auto level = loadLevel(options.level);
  if (!level) return level.error();
  auto camera = chooseCamera(*level, options.camera, options.seconds);
  if (!camera) return camera.error();
  if (options.pose) *camera = placed(*camera, *options.pose);

  const params::Table& table = (*catalogue)->table();
  truth::Settings settings;
  settings.width = options.size.first;
  settings.height = options.size.second;
  settings.seconds = options.seconds;
  settings.samples = options.samples;
  for (const auto& [id, target] : {std::pair{"medium.sigma_t", &settings.medium.sigma_t},
                                   {"medium.albedo", &settings.medium.albedo},
                                   {"medium.g", &settings.medium.g}}) {
    if (!table.find(id))
      return failed("truth: the plugin in use has no parameter " + std::string(id) +
                    "; the volumetrics plugin is needed");
    *target = table.value(id);
  }
  auto picture = truth::render(level->scene, *camera, level->lights(options.seconds), settings);
  if (!picture) return picture.error();
  if (auto done = outputs.write("--out", [&](const Path& p) { return image::writeExr(p, scatterImage(*picture)); });
      !done)
    return done;
  if (auto done = outputs.write("--depth",
                                [&](const Path& p) {
                                  return image::writeExr(p, {picture->width, picture->height, 1, picture->distance});
                                });
      !done)
    return done;
  std::string text;
  for (const Path& file : outputs.paths()) text += file.string() + "\n";
  if (auto done = outputs.commit([&text] { return print(text); }); !done) return done;
  std::vector<std::string> warnings = (*catalogue)->warnings();
  warnings.insert(warnings.end(), level->warnings.begin(), level->warnings.end());
  std::vector<std::string> notes = level->notes;
  if (std::string far = scene::roundingNote(*camera); !far.empty()) notes.push_back(std::move(far));
  tell(warnings, notes);
  return {};
}

}  // namespace tyndall::app
