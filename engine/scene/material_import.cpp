#include "import_parts.hpp"

namespace tyndall::scene {
namespace {

using document::Document;

/// Copies textures and images on first use.
struct Importer {
  Document& document;
  Scene& scene;
  Warnings& warnings;
  std::vector<std::int32_t> textureOf = std::vector<std::int32_t>(document.textures.size(), kNone);
  std::vector<std::int32_t> imageOf = std::vector<std::int32_t>(document.images.size(), kNone);

  void use(TextureUse& use) {
    if (!use.used()) return;
    const document::Texture& in = document.textures[use.texture];
    if (in.source == kNone) {
      warnings.add(element("textures", use.texture) + " has no PNG or JPEG image and was left out");
      use = {};
      return;
    }
    if (imageOf[in.source] == kNone && document.images[in.source].rgba.empty()) {
      use = {};  // counted where its image was read
      return;
    }
    std::int32_t& texture = textureOf[use.texture];
    if (texture == kNone) {
      std::int32_t& image = imageOf[in.source];
      if (image == kNone) {
        image = static_cast<std::int32_t>(scene.images.size());
        scene.images.push_back(std::move(document.images[in.source]));
      }
      texture = static_cast<std::int32_t>(scene.textures.size());
      scene.textures.push_back({image, in.sampler});
    }
    use.texture = texture;
  }

  void cookie(Light& light, std::string what) {
    if (!light.cookie) return;
    TextureUse shown{light.cookie->texture};
    use(shown);
    light.cookie->texture = shown.texture;
    if (!shown.used()) {
      light.cookie.reset();
      return;
    }
    const Image& image = scene.images[scene.textures[shown.texture].image];
    if (light.kind != LightKind::kPoint || pointCookieShape(image)) return;
    if (!light.name.empty()) what += " " + inQuotes(light.name);
    warnings.count("cookies of another shape",
                   what + " is a point light whose cookie is " + std::to_string(image.width) + "x" +
                       std::to_string(image.height) +
                       "; it must be 2:1 (equirectangular) or 6:1 (six cube faces in a row)",
                   kEachLeftOut);
    light.cookie.reset();
  }
};

}  // namespace

void importMaterials(Document& document, Scene& scene, Warnings& warnings) {
  Importer importer{document, scene, warnings};
  for (std::size_t i = 0; i < document.materials.size(); ++i) {
    Material m = document.materials[i].material;
    for (TextureUse* use :
         {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture, &m.emissiveTexture})
      importer.use(*use);
    if (document.materials[i].specularGlossiness)
      warnings.add("materials of the archived specular-glossiness kind become ordinary dielectrics");
    scene.materials.push_back(std::move(m));
  }
  for (std::size_t i = 0; i < document.lights.size(); ++i) importer.cookie(document.lights[i], element("lights", i));
}

}  // namespace tyndall::scene
