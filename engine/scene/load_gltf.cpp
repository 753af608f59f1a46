#include <new>

#include "base/file.hpp"
#include "import_parts.hpp"
#include "parse_gltf.hpp"
#include "scene/check.hpp"
#include "scene/gltf.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

/// Sound transforms can still multiply to something that no renderer can use.
void checkExtent(const Scene& scene) {
  const auto matrices = worldMatrices(scene, 0);
  const glm::vec3 limit(kMaxExtent);
  for (std::size_t i = 0; i < matrices.size(); ++i)
    for (int column = 0; column < 4; ++column)
      if (!glm::all(glm::lessThanEqual(glm::abs(glm::vec3(matrices[i][column])), limit)))  // false for NaN as well
        refuse(element("nodes", scene.nodes[i].order) + " is moved or scaled beyond " +
               std::to_string(static_cast<long>(kMaxExtent)) + " m");
  const Bounds bounds = worldBounds(scene, matrices);
  if (bounds.empty()) return;
  if (!glm::all(glm::lessThanEqual(glm::abs(bounds.min), limit)) ||
      !glm::all(glm::lessThanEqual(glm::abs(bounds.max), limit)))
    refuse("it reaches farther than " + std::to_string(static_cast<long>(kMaxExtent)) + " m from the origin");
}

Import import(const std::filesystem::path& path, std::vector<std::byte> file) {
  Warnings warnings;
  Prepared prepared = prepare(openContainer(file, warnings), path, file.size(), warnings);
  file = {};  // everything needed has been copied out
  document::Document document = parseGltf(std::move(prepared), warnings);
  Import out;
  out.scene.exposure = document.exposure;
  importMaterials(document, out.scene, warnings);
  const std::vector<std::int32_t> sceneNode = importNodes(document, out.scene, warnings);
  importMeshes(document, out.scene, warnings);
  importAnimations(document, sceneNode, out.scene, warnings);
  checkExtent(out.scene);
  // What is left is a promise of ours; a file that finds a gap in the checks above is refused all the same.
  if (auto sound = checkScene(out.scene); !sound) refuse("is inconsistent: " + oneLine(sound.error().message));
  out.warnings = warnings.take();
  return out;
}

}  // namespace

Result<Import> loadGltf(const std::filesystem::path& path) {
  auto file = readFile(path, kMaxFileBytes);
  if (!file) return file.error();
  try {
    return import(path, file.take());
  } catch (const Refusal& refusal) {
    return failed(path.string() + ": " + refusal.reason);
  } catch (const std::bad_alloc&) {
    return failed(path.string() + ": there is not enough memory to load it");
  } catch (const std::exception& error) {
    return failed(path.string() + ": cannot be loaded: " + oneLine(error.what()));
  }
}

}  // namespace tyndall::scene
