// A glTF document between the parser and the importer: what gltf.cpp made of tinygltf's model. Shapes and indices into
// the document's arrays are right (schema.hpp); what lies in buffers is not yet checked.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall::scene::document {

struct BufferView {
  int buffer = kNone;
  std::size_t byteOffset = 0, byteLength = 0;
  std::size_t byteStride = 0;  ///< 0: tightly packed
};

struct Sparse {
  std::size_t count = 0;  ///< 0: not sparse
  int indexView = kNone, valueView = kNone;
  std::size_t indexOffset = 0, valueOffset = 0;
  int indexType = 0;
};

struct Accessor {
  int view = kNone;  ///< kNone: all zeros
  std::size_t byteOffset = 0;
  int componentType = 0;  ///< GL enumerant, 5120...5126
  int width = 0;          ///< 1 scalar ... 4 vec4; 0: a matrix, which nothing here reads
  std::size_t count = 0;
  bool normalized = false;
  Sparse sparse;
};

struct Primitive {
  std::map<std::string, int> attributes;  ///< semantic to accessor
  int indices = kNone, material = kNone;
  int mode = 4;
  bool morphed = false;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

struct Node {
  scene::Node node;  ///< without parent; mesh, camera and light count as in the document
  std::vector<int> children;
  bool skinned = false;
  bool visible = true;              ///< KHR_node_visibility: else nothing of its subtree is there
  std::optional<bool> castsShadow;  ///< nothing: as its parent
};

struct SceneRoots {
  std::string name;
  std::vector<int> nodes;
};

struct Texture {
  int source = kNone;
  Sampler sampler;
};

enum TextureSlot { kBaseColorSlot, kMetallicRoughnessSlot, kNormalSlot, kOcclusionSlot, kEmissiveSlot, kTextureSlots };

struct Material {
  scene::Material material;         ///< its textures count as in the document
  int uvSets[kTextureSlots] = {};   ///< TEXCOORD_n that each texture reads
  bool specularGlossiness = false;  ///< converted, which loses the coloured reflection
};

struct AnimationSampler {
  int input = kNone, output = kNone;
  Interpolation interpolation = Interpolation::kLinear;
};
struct AnimationChannel {
  int sampler = kNone, node = kNone;
  std::string path;
};
struct Animation {
  std::string name;
  std::vector<AnimationSampler> samplers;
  std::vector<AnimationChannel> channels;
};

struct Document {
  std::optional<float> exposure;                    ///< Scene::exposure
  std::vector<std::vector<unsigned char>> buffers;  ///< a buffer whose bytes are absent is empty
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;  ///< empty (0 x 0) when no material shows it
  std::vector<Node> nodes;
  std::vector<SceneRoots> scenes;
  int defaultScene = kNone;
  std::vector<std::optional<Camera>> cameras;  ///< nothing: orthographic
  std::vector<Light> lights;
  std::vector<Animation> animations;
};

}  // namespace tyndall::scene::document
