// The importer's steps from a document to a Scene.
#pragma once

#include <span>
#include <vector>

#include "document.hpp"
#include "import_log.hpp"

namespace tyndall::scene {

/// Materials, with the textures and images that they show; then those that the document's lights shine through (whose
/// Cookie::texture counts as in the scene afterwards), and no others.
void importMaterials(document::Document& document, Scene& scene, Warnings& warnings);

/// Nodes of the default scene (or the first one, or all roots), parents first, and the cameras and lights on them.
/// Node::mesh still counts as in the document. Returns the node's index in `scene` for each of the document's, or
/// kNone.
std::vector<std::int32_t> importNodes(document::Document& document, Scene& scene, Warnings& warnings);

/// The meshes that `scene`'s nodes show; renumbers Node::mesh.
void importMeshes(const document::Document& document, Scene& scene, Warnings& warnings);

/// Channels that move a node of the scene.
void importAnimations(const document::Document& document, std::span<const std::int32_t> sceneNode, Scene& scene,
                      Warnings& warnings);

/// One triangle list, finished: normals and tangents made where the file has none. Empty when nothing can be drawn.
std::optional<Primitive> importPrimitive(const document::Document& document, const document::Primitive& in,
                                         const std::string& what, Warnings& warnings);

/// Unit normals from the triangles for those vertices whose normal is zero. Returns how many.
std::size_t repairNormals(Primitive& primitive);

/// Tangents along growing u, and their handedness; some unit vector across the normal where uv says nothing.
void computeTangents(Primitive& primitive);
/// Any unit vector perpendicular to the unit vector n.
glm::vec3 perpendicular(const glm::vec3& n);

}  // namespace tyndall::scene
