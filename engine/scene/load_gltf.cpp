#include <new>

#include "base/file.hpp"
#include "base/hash.hpp"
#include "import_parts.hpp"
#include "parse_gltf.hpp"
#include "scene/check.hpp"
#include "scene/gltf.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

bool within(const glm::vec3& v) {
  return glm::all(glm::lessThanEqual(glm::abs(v), glm::vec3(kMaxExtent)));  // false for NaN as well
}

/// Sound transforms can still multiply to something that no renderer can use: such nodes lose what stands on them.
void dropBeyondExtent(Scene& scene, Warnings& warnings) {
  const auto matrices = worldMatrices(scene, 0);
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    Node& node = scene.nodes[i];
    bool good = true;
    for (int column = 0; column < 4; ++column) good = good && within(glm::vec3(matrices[i][column]));
    if (good && node.mesh != kNone)
      for (const Primitive& p : scene.meshes[node.mesh].primitives)
        for (int corner = 0; corner < 8; ++corner) {
          const glm::vec3 c(corner & 1 ? p.bounds.max.x : p.bounds.min.x, corner & 2 ? p.bounds.max.y : p.bounds.min.y,
                            corner & 4 ? p.bounds.max.z : p.bounds.min.z);
          good = good && within(glm::vec3(matrices[i] * glm::vec4(c, 1)));
        }
    if (good || (node.mesh == kNone && node.camera == kNone && node.light == kNone)) continue;
    warnings.count(
        "nodes that are moved or scaled too far",
        element("nodes", node.order) + " reaches beyond " + std::to_string(static_cast<long>(kMaxExtent)) + " m",
        "what stands on each is left out");
    node.mesh = node.camera = node.light = kNone;
  }
}

bool hasTriangles(const Scene& scene) {
  for (const Node& node : scene.nodes)
    if (node.mesh != kNone && !scene.meshes[node.mesh].primitives.empty()) return true;
  return false;
}

/// A matrix may flatten all that tells where a camera looks or a light shines. Rotations and scales never do.
void warnOfLostDirections(const Scene& scene, Warnings& warnings) {
  const auto turns = worldTurns(scene, 0);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (turns[i]) continue;
    const std::string matrix = element("nodes", node.order) + ": its matrix or that of a node above it flattens ";
    constexpr const char* kRepair =
        " is taken as -Z; a matrix that can be inverted, or rotation and scale, would tell it";
    if (node.camera != kNone) warnings.add(matrix + "where its camera looks, which" + kRepair);
    if (node.light != kNone && (scene.lights[node.light].kind != LightKind::kPoint || scene.lights[node.light].cookie))
      warnings.add(matrix + "where its light shines, which" + kRepair);
  }
}

Import import(const std::filesystem::path& path, std::vector<std::byte> file) {
  Warnings warnings;
  Hash content;
  content.bytes(file);
  Prepared prepared = prepare(openContainer(file, warnings), path, file.size(), warnings);
  file = {};  // everything needed has been copied out
  const bool hasMeshes = prepared.hasMeshes;
  const std::uint64_t contentHash = prepared.contentHash;
  document::Document document = parseGltf(std::move(prepared), warnings);
  Import out;
  out.contentHash = content.add(contentHash).value();
  out.scene.exposure = document.exposure;
  importMaterials(document, out.scene, warnings);
  const std::vector<std::int32_t> sceneNode = importNodes(document, out.scene, warnings);
  importMeshes(document, out.scene, warnings);
  importAnimations(document, sceneNode, out.scene, warnings);
  dropBeyondExtent(out.scene, warnings);
  // One bad part does not lose the rest; a level of which nothing is left is lost.
  if (hasMeshes && !hasTriangles(out.scene) && !warnings.firstCounted().empty()) refuse(warnings.firstCounted());
  warnOfLostDirections(out.scene, warnings);
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
  } catch (const Escape& escape) {
    return failed(path.string() + ": " + escape.reason);
  } catch (const std::bad_alloc&) {
    return failed(path.string() + ": there is not enough memory to load it");
  } catch (const std::exception& error) {
    return failed(path.string() + ": cannot be loaded: " + oneLine(error.what()));
  }
}

}  // namespace tyndall::scene
