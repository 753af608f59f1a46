#include <algorithm>
#include <cmath>

#include "import_parts.hpp"

namespace tyndall::scene {
namespace {

using document::Document;

constexpr const char* kTree = "nodes that stand in two places of the tree";
constexpr const char* kTreeConsequence = "each stands where it is listed first";

/// Parent of each node, from the lists of children: the first that lists it. The others' lists lose it.
std::vector<std::int32_t> parents(Document& document, Warnings& warnings) {
  std::vector<std::int32_t> parentOf(document.nodes.size(), kNone);
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    std::vector<int> kept;
    for (const int child : document.nodes[i].children) {
      if (parentOf[child] == kNone) {
        parentOf[child] = static_cast<std::int32_t>(i);
        kept.push_back(child);
      } else {
        warnings.count(kTree,
                       element("nodes", child) + " is listed as a child twice, by nodes " +
                           std::to_string(parentOf[child]) + " and " + std::to_string(i),
                       kTreeConsequence);
      }
    }
    document.nodes[i].children = std::move(kept);
  }
  return parentOf;
}

std::vector<int> roots(const Document& document, const std::vector<std::int32_t>& parentOf, Scene& scene,
                       Warnings& warnings) {
  std::vector<int> out;
  if (document.scenes.empty()) {
    for (std::size_t i = 0; i < parentOf.size(); ++i)
      if (parentOf[i] == kNone) out.push_back(static_cast<int>(i));
    return out;
  }
  const document::SceneRoots& chosen = document.scenes[document.defaultScene == kNone ? 0 : document.defaultScene];
  scene.name = chosen.name;
  // A root without a parent cannot be part of a cycle, and with one parent each, nothing below it can.
  std::vector<bool> listed(document.nodes.size(), false);
  for (const int root : chosen.nodes) {
    if (parentOf[root] != kNone)
      warnings.count(
          kTree,
          "the scene lists " + element("nodes", root) + ", which is a child of " + element("nodes", parentOf[root]),
          "each stands below its parent");
    else if (listed[root])
      warnings.count(kTree, "the scene lists " + element("nodes", root) + " twice", kTreeConsequence);
    else
      out.push_back(root);
    listed[root] = true;
  }
  return out;
}

void repairTransform(Node& n, const std::string& name, Warnings& warnings) {
  if (n.matrix) {
    glm::mat4& m = *n.matrix;
    const glm::vec4 last(m[0][3], m[1][3], m[2][3], m[3][3]);
    if (glm::any(glm::greaterThan(glm::abs(last - glm::vec4(0, 0, 0, 1)), glm::vec4(1e-4f)))) {
      warnings.count("matrices that are not affine", name + ".matrix is not affine", "each node stays unmoved");
      n.matrix.reset();
      return;
    }
    for (int column = 0; column < 4; ++column) m[column][3] = column == 3 ? 1.0f : 0.0f;
    return;
  }
  // In double: components may be anything a float holds.
  const glm::dquat q(n.rotation.w, n.rotation.x, n.rotation.y, n.rotation.z);
  const double length = std::sqrt(glm::dot(q, q));
  if (length < 1e-20) {
    warnings.add(name + ".rotation is zero; it does not rotate");
    n.rotation = glm::quat(1, 0, 0, 0);
    return;
  }
  if (std::abs(length - 1) > 0.01) warnings.add(name + ".rotation is not a unit quaternion; it was normalised");
  const glm::dquat unit = q / length;
  n.rotation = glm::quat(static_cast<float>(unit.w), static_cast<float>(unit.x), static_cast<float>(unit.y),
                         static_cast<float>(unit.z));
}

/// What an outer cone of nothing becomes, radians.
constexpr float kLeastOuterCone = 1e-3f;

/// Cameras and lights, copied on first use.
struct Attachments {
  const Document& document;
  Scene& scene;
  Warnings& warnings;
  std::vector<std::int32_t> cameraOf = std::vector<std::int32_t>(document.cameras.size(), kNone);
  std::vector<std::int32_t> lightOf = std::vector<std::int32_t>(document.lights.size(), kNone);

  void camera(std::int32_t& index) {
    if (index == kNone) return;
    const std::string name = element("cameras", index);
    if (!document.cameras[index]) {
      warnings.add(name + " is orthographic and was left out; only perspective cameras are read so far");
      ++scene.orthographicCameras;
      index = kNone;
      return;
    }
    std::int32_t& out = cameraOf[index];
    if (out == kNone) {
      Camera c = *document.cameras[index];
      if (c.zfar && *c.zfar <= c.znear) {
        warnings.add(name + ".zfar is not beyond znear; it was left out");
        c.zfar.reset();
      }
      out = static_cast<std::int32_t>(scene.cameras.size());
      scene.cameras.push_back(std::move(c));
    }
    index = out;
  }

  void light(std::int32_t& index) {
    if (index == kNone) return;
    std::int32_t& out = lightOf[index];
    if (out == kNone) {
      Light l = document.lights[index];
      // Equal angles, which the extension forbids and exporters write, are a cone with a hard edge.
      if (l.kind == LightKind::kSpot && (l.innerConeAngle > l.outerConeAngle || l.outerConeAngle == 0)) {
        warnings.add(element("lights", index) +
                     " has an inner cone that is not inside its outer cone; the inner one was shrunk");
        l.outerConeAngle = std::max(l.outerConeAngle, kLeastOuterCone);
        l.innerConeAngle = 0.99f * l.outerConeAngle;
      }
      out = static_cast<std::int32_t>(scene.lights.size());
      scene.lights.push_back(std::move(l));
    }
    index = out;
  }
};

}  // namespace

std::vector<std::int32_t> importNodes(Document& document, Scene& scene, Warnings& warnings) {
  const std::vector<std::int32_t> parentOf = parents(document, warnings);
  std::vector<std::int32_t> sceneNode(document.nodes.size(), kNone);
  std::vector<bool> hidden;  // of the scene's nodes
  Attachments attachments{document, scene, warnings};
  // Depth first with a stack of our own: the file decides how deep the tree is.
  std::vector<int> stack = roots(document, parentOf, scene, warnings);
  std::reverse(stack.begin(), stack.end());
  while (!stack.empty()) {
    const int i = stack.back();
    stack.pop_back();
    sceneNode[i] = static_cast<std::int32_t>(scene.nodes.size());
    const document::Node& in = document.nodes[i];
    Node n = in.node;
    n.order = static_cast<std::uint32_t>(i);
    n.parent = parentOf[i] == kNone ? kNone : sceneNode[parentOf[i]];
    repairTransform(n, element("nodes", i), warnings);
    hidden.push_back(!in.visible || (n.parent != kNone && hidden[n.parent]));
    n.castsShadow = in.castsShadow.value_or(n.parent == kNone || scene.nodes[n.parent].castsShadow);
    if (hidden.back()) n.mesh = n.light = kNone;
    if (in.skinned) warnings.add("skins are not supported; skinned meshes stand in their rest pose");
    attachments.camera(n.camera);
    attachments.light(n.light);
    scene.nodes.push_back(std::move(n));
    stack.insert(stack.end(), in.children.rbegin(), in.children.rend());
  }
  return sceneNode;
}

}  // namespace tyndall::scene
