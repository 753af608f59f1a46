#include <algorithm>
#include <array>
#include <cmath>

#include "accessor.hpp"
#include "import_parts.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

using document::Document;

enum : int { kTriangles = 4, kStrip = 5, kFan = 6 };

std::vector<std::uint32_t> readIndices(const Document& document, const document::Primitive& in, std::size_t vertices,
                                       const std::string& what) {
  std::vector<std::uint32_t> out;
  if (in.indices == kNone) {
    out.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i) out[i] = static_cast<std::uint32_t>(i);
    return out;
  }
  const AccessorReader reader(document, in.indices, what + ".indices");
  const int type = reader.componentType();
  if (reader.width() != 1 || (type != 5121 && type != 5123 && type != 5125))
    refuse(what + ".indices are not unsigned integers");
  out.resize(reader.count());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = reader.index(i);
  return out;
}

/// Leaves out the triangles that have no place: an index beyond the vertices, or a position that is not finite.
void dropUnplaced(std::vector<std::uint32_t>& indices, const AccessorReader& positions, const std::string& what,
                  Warnings& warnings) {
  std::string first;
  const auto placed = [&](std::size_t i) {
    const std::uint32_t vertex = indices[i];
    if (vertex >= positions.count()) {
      if (first.empty())
        first = what + "." + element("indices", i) + " is " + std::to_string(vertex) + "; there are " +
                std::to_string(positions.count()) + " vertices";
      return false;
    }
    if (positions.finite(vertex)) return true;
    if (first.empty()) first = what + ".POSITION: element " + std::to_string(vertex) + " is not finite";
    return false;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    if (placed(i) && placed(i + 1) && placed(i + 2)) {
      for (std::size_t c = 0; c < 3; ++c) indices[kept + c] = indices[i + c];
      kept += 3;
    } else {
      warnings.count("triangles without a place", first, kEachLeftOut);
    }
  }
  indices.resize(kept);
}

/// A triangle list of the same triangles, glTF 2.0 section 3.7.2.1.
std::vector<std::uint32_t> triangulated(std::vector<std::uint32_t> in, int mode, const std::string& what,
                                        Warnings& warnings) {
  if (mode == kTriangles) {
    if (in.size() % 3) {
      warnings.add(what + " ends with an incomplete triangle, which was left out");
      in.resize(in.size() / 3 * 3);
    }
    return in;
  }
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i + 2 < in.size(); ++i) {
    if (mode == kFan)
      out.insert(out.end(), {in[i + 1], in[i + 2], in[0]});
    else
      out.insert(out.end(), {in[i], in[i + 1 + i % 2], in[i + 2 - i % 2]});
  }
  return out;
}

/// Renumbers `indices` to 0...n-1 and returns the vertex behind each new number, in the old order. Vertices that no
/// triangle uses go: exporters let many primitives share one long vertex list.
std::vector<std::uint32_t> compact(std::vector<std::uint32_t>& indices, std::size_t vertices) {
  std::vector<std::uint32_t> used;
  if (vertices <= 4 * indices.size()) {
    std::vector<std::uint32_t> newOf(vertices, 0);
    for (const std::uint32_t i : indices) newOf[i] = 1;
    for (std::uint32_t i = 0; i < newOf.size(); ++i) {
      if (!newOf[i]) continue;
      newOf[i] = static_cast<std::uint32_t>(used.size());
      used.push_back(i);
    }
    for (std::uint32_t& i : indices) i = newOf[i];
  } else {  // few triangles: cost by their number, not by the list's length
    used = indices;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::uint32_t& i : indices)
      i = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), i) - used.begin());
  }
  return used;
}

/// The texture coordinates that the material reads. A Vertex has one pair, so a second set is said and not used.
int uvSet(const document::Material& material, const std::string& what, Warnings& warnings) {
  const Material& m = material.material;
  const std::array<const TextureUse*, document::kTextureSlots> uses = {
      &m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture, &m.emissiveTexture};
  int set = kNone;
  for (const int slot : {document::kBaseColorSlot, document::kNormalSlot, document::kMetallicRoughnessSlot,
                         document::kEmissiveSlot, document::kOcclusionSlot}) {
    if (!uses[slot]->used()) continue;
    if (set == kNone) set = material.uvSets[slot];
    if (material.uvSets[slot] != set)
      warnings.add(what + "'s textures use different texture coordinates; all get TEXCOORD_" + std::to_string(set));
  }
  return set;
}

/// One attribute if present, checked for its width and count; refuses a broken one.
std::optional<AccessorReader> opened(const Document& document, const document::Primitive& in,
                                     const std::string& semantic, int low, int high, std::size_t count,
                                     const std::string& what) {
  const auto found = in.attributes.find(semantic);
  if (found == in.attributes.end()) return {};
  std::optional<AccessorReader> reader(std::in_place, document, found->second, what + "." + semantic);
  if (reader->width() < low || reader->width() > high)
    refuse(what + "." + semantic + " has " + std::to_string(reader->width()) + " components; " + std::to_string(low) +
           " are expected");
  if (count && reader->count() != count)
    refuse(what + "." + semantic + " has " + std::to_string(reader->count()) + " elements; POSITION has " +
           std::to_string(count));
  return reader;
}

/// The same for what a mesh can do without: a broken attribute is as if it were not there.
std::optional<AccessorReader> open(const Document& document, const document::Primitive& in, const std::string& semantic,
                                   int low, int high, std::size_t count, const std::string& what, Warnings& warnings) {
  try {
    return opened(document, in, semantic, low, high, count, what);
  } catch (const Refusal& refusal) {
    warnings.count("broken attributes", refusal.reason, kEachLeftOut);
    return {};
  }
}

/// An element of an attribute that a mesh can do without; `fallback` for one that is not finite, which is counted.
glm::vec4 sane(const AccessorReader& reader, std::uint32_t i, const glm::vec4& fallback, bool normalize,
               const std::string& what, Warnings& warnings) {
  if (reader.finite(i)) return reader.vector(i, fallback, normalize);
  warnings.count("vertices that are not finite", what + ": element " + std::to_string(i), "each is repaired");
  return fallback;
}

glm::vec3 unitOrZero(const glm::vec3& v) {
  // In double: the square of a float may overflow one.
  const glm::dvec3 d(v);
  const double length = std::sqrt(glm::dot(d, d));
  return length > 1e-12 ? glm::vec3(d / length) : glm::vec3(0);
}

}  // namespace

std::optional<Primitive> importPrimitive(const Document& document, const document::Primitive& in,
                                         const std::string& what, Warnings& warnings) {
  if (in.mode < kTriangles) {
    warnings.add("points and lines are not drawn and were left out");
    return {};
  }
  if (in.morphed) warnings.add("morph targets are not supported; meshes keep their rest shape");
  const auto positions = opened(document, in, "POSITION", 3, 3, 0, what);
  if (!positions || positions->allZero()) {
    warnings.add(what + " has no positions and was left out");
    return {};
  }
  const std::size_t count = positions->count();
  const auto normals = open(document, in, "NORMAL", 3, 3, count, what, warnings);
  const auto tangents = normals ? open(document, in, "TANGENT", 4, 4, count, what, warnings) : std::nullopt;
  const auto colors = open(document, in, "COLOR_0", 3, 4, count, what, warnings);
  int set = in.material == kNone ? kNone
                                 : uvSet(document.materials[in.material], element("materials", in.material), warnings);
  const auto uvs = open(document, in, "TEXCOORD_" + std::to_string(std::max(set, 0)), 2, 2, count, what, warnings);
  if (set != kNone && !uvs)
    warnings.add(what + " has no TEXCOORD_" + std::to_string(set) + ", which its material reads; it gets 0, 0");

  Primitive out;
  out.material = in.material;
  out.indices = triangulated(readIndices(document, in, count, what), in.mode, what, warnings);
  dropUnplaced(out.indices, *positions, what, warnings);
  if (out.indices.empty()) {
    warnings.add(what + " has no triangle and was left out");
    return {};
  }
  std::vector<std::uint32_t> source;
  if (normals) {
    source = compact(out.indices, count);
  } else {  // glTF 2.0 section 3.7.2.1: flat normals, so every triangle gets vertices of its own
    source = out.indices;
    for (std::size_t i = 0; i < out.indices.size(); ++i) out.indices[i] = static_cast<std::uint32_t>(i);
  }
  out.vertices.resize(source.size());
  bool clamped = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    Vertex& v = out.vertices[i];
    const std::uint32_t s = source[i];
    v.position = positions->vector(s);
    if (normals)
      v.normal = unitOrZero(sane(*normals, s, glm::vec4(0), false, what + ".NORMAL", warnings));
    else
      v.normal = glm::vec3(0);
    if (uvs) v.uv = sane(*uvs, s, glm::vec4(0), false, what + ".TEXCOORD", warnings);
    if (colors) v.color = sane(*colors, s, glm::vec4(1), colors->componentType() != 5126, what + ".COLOR_0", warnings);
    const glm::vec4 color = glm::clamp(v.color, 0.0f, 1.0f);
    clamped = clamped || color != v.color;
    v.color = color;
    out.bounds.add(v.position);
  }
  if (clamped) warnings.add(what + ".COLOR_0 leaves 0..1; the nearest is used");
  const std::size_t repaired = repairNormals(out);
  if (normals && repaired)
    warnings.add(what + " has " + std::to_string(repaired) + " zero normals; they were made from its triangles");
  computeTangents(out);
  for (std::size_t i = 0; tangents && i < source.size(); ++i) {
    const glm::vec4 t = sane(*tangents, source[i], glm::vec4(0), false, what + ".TANGENT", warnings);
    const glm::vec3 direction = unitOrZero(glm::vec3(t));
    if (direction != glm::vec3(0)) out.vertices[i].tangent = glm::vec4(direction, t.w < 0 ? -1.0f : 1.0f);
  }
  return out;
}

void importMeshes(const Document& document, Scene& scene, Warnings& warnings) {
  std::vector<std::int32_t> meshOf(document.meshes.size(), kNone);
  std::vector<int> order;
  for (Node& node : scene.nodes) {
    if (node.mesh == kNone) continue;
    std::int32_t& mesh = meshOf[node.mesh];
    if (mesh == kNone) {
      mesh = static_cast<std::int32_t>(order.size());
      order.push_back(node.mesh);
    }
    node.mesh = mesh;
  }
  // Many primitives may name the same accessors, so a small file can ask for much: count before allocating.
  std::size_t vertices = 0, indices = 0;
  for (const int m : order) {
    for (const document::Primitive& p : document.meshes[m].primitives) {
      const auto position = p.attributes.find("POSITION");
      if (p.mode < kTriangles || position == p.attributes.end()) continue;
      const std::size_t positions = document.accessors[position->second].count;
      const std::size_t corners =
          (p.indices == kNone ? positions : document.accessors[p.indices].count) * (p.mode == kTriangles ? 1 : 3);
      indices += corners;
      vertices += p.attributes.contains("NORMAL") ? std::min(corners, positions) : corners;
    }
    if (vertices > kMaxVertices) refuse("its meshes have more than " + std::to_string(kMaxVertices) + " vertices");
    if (indices > kMaxIndices) refuse("its meshes have more than " + std::to_string(kMaxIndices) + " indices");
  }
  for (const int m : order) {
    Mesh mesh{document.meshes[m].name, {}};
    for (std::size_t p = 0; p < document.meshes[m].primitives.size(); ++p) {
      try {
        auto primitive = importPrimitive(document, document.meshes[m].primitives[p],
                                         element("meshes", m) + "." + element("primitives", p), warnings);
        if (primitive) mesh.primitives.push_back(std::move(*primitive));
      } catch (const Refusal& refusal) {
        warnings.count("broken parts of meshes", refusal.reason, kEachLeftOut);
      }
    }
    scene.meshes.push_back(std::move(mesh));
  }
}

}  // namespace tyndall::scene
