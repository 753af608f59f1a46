#include "render_files.hpp"

#include "base/file.hpp"
#include "image/image_io.hpp"

namespace tyndall::app {
namespace {

struct OptionFile {
  const char* option;
  const std::string& path;
  const char* extension;
};

}  // namespace

Result<void> addRenderFiles(Outputs& outputs, const RenderOptions& options, const std::filesystem::path& level) {
  outputs.protect(level);
  if (!options.settings.preset.empty()) outputs.protect(options.settings.preset);
  for (const OptionFile& file :
       {OptionFile{"--out", options.picture, ".png"}, OptionFile{"--scatter", options.scatter, ".exr"},
        OptionFile{"--depth", options.depth, ".exr"}, OptionFile{"--view-exr", options.viewExr, ".exr"},
        OptionFile{"--stats", options.stats, ".json"}})
    if (!file.path.empty())
      if (auto added = outputs.add(file.option, file.path, file.extension); !added) return added;
  return {};
}

Result<void> writeRenderFiles(Outputs& outputs, const RenderRun& run, const std::string& stats,
                              const std::function<Result<void>()>& tell) {
  const Readback& readback = run.readback;
  using Path = std::filesystem::path;
  if (auto done = outputs.write("--out", [&](const Path& p) { return image::writePng(p, readback.picture()); }); !done)
    return done;
  if (auto done = outputs.write("--scatter", [&](const Path& p) { return image::writeExr(p, readback.scatter()); });
      !done)
    return done;
  if (auto done = outputs.write("--depth", [&](const Path& p) { return image::writeExr(p, readback.distance()); });
      !done)
    return done;
  const auto writeView = [&](const Path& p) -> Result<void> {
    const std::vector<ViewPicture> views = run.views.pictures();
    if (views.empty() || views.front().values.empty())
      return failed("this frame has no image for the view; another setting or light may have");
    return image::writeExr(p, exrOf(views.front()));
  };
  if (auto done = outputs.write("--view-exr", writeView); !done) return done;
  if (auto done = outputs.write("--stats", [&](const Path& p) { return writeTextAtomically(p, stats); }); !done)
    return done;
  return outputs.commit(tell);
}

}  // namespace tyndall::app
