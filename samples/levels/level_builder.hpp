// Puts a level together: keeps the indices of a scene::Scene right.
#pragma once

#include <string>

#include "canvas.hpp"
#include "mesh_builder.hpp"
#include "scene/scene.hpp"

namespace tyndall::levels {

class LevelBuilder {
 public:
  explicit LevelBuilder(const std::string& name) { scene_.name = name; }

  std::int32_t texture(scene::Image image, scene::Wrap wrap = scene::Wrap::kRepeat, bool mips = true);
  std::int32_t material(scene::Material material);
  /// An opaque dielectric with the surface's colour, normals and roughness.
  /// `bounced`: light that comes back from all around, as radiance of a white surface; a level without a sky bakes it
  /// in.
  std::int32_t material(const std::string& name, const Surface& surface, const glm::vec4& factor = glm::vec4(1),
                        const glm::vec3& bounced = glm::vec3(0));
  /// A material without textures.
  std::int32_t plain(const std::string& name, const glm::vec3& color, float roughness, float metallic = 0);
  /// A dielectric without textures that shines: `light` is its radiance.
  std::int32_t glowing(const std::string& name, const glm::vec4& color, const glm::vec3& light, float roughness,
                       scene::AlphaMode mode = scene::AlphaMode::kOpaque);
  /// A pane with a picture, lit from behind: what it lets through of `light` is its emission. Blended, so it neither
  /// casts a shadow nor ends a view ray.
  std::int32_t pane(const std::string& name, std::int32_t picture, const glm::vec3& light);
  /// A picture cut out along its alpha, seen from both sides.
  std::int32_t cutout(const std::string& name, std::int32_t picture, const glm::vec3& tint, float roughness,
                      float metallic = 0);

  const scene::Material& materialAt(std::int32_t material) const { return scene_.materials[material]; }

  std::int32_t mesh(const std::string& name, std::vector<scene::Primitive> primitives);
  std::int32_t node(scene::Node node);
  std::int32_t node(const std::string& name, std::int32_t mesh, const glm::vec3& at = glm::vec3(0), float yaw = 0,
                    float scale = 1, std::int32_t parent = scene::kNone);
  /// One mesh used by one node at the origin.
  void single(const std::string& name, std::vector<scene::Primitive> primitives);

  /// `toSun`: direction from the level to the sun.
  void sun(const glm::vec3& toSun, const glm::vec3& color, float lux, const std::string& name = "sun");
  /// A lamp: candela, and how far it reaches in metres. Returns the node.
  std::int32_t point(const std::string& name, const glm::vec3& at, const glm::vec3& color, float candela, float range,
                     std::int32_t parent = scene::kNone);
  /// A cone of light; half angles in degrees; `cookie`: the texture that it shines through. Returns the node.
  std::int32_t spot(const std::string& name, const glm::vec3& at, const glm::vec3& target, const glm::vec3& color,
                    float candela, float innerCone, float outerCone, float range, std::int32_t cookie = scene::kNone);
  /// Degrees. Returns the node.
  std::int32_t camera(const std::string& name, const glm::vec3& eye, const glm::vec3& target, float verticalFov,
                      float zfar);

  /// One animation per level: channels are added to it, and it loops with its longest channel.
  void animate(scene::AnimationChannel channel);
  /// A pendulum or door: turns the node about `axis` by middle + amplitude * sin, sampled so finely that linear
  /// interpolation stays true; starts and ends alike.
  void animateSwing(std::int32_t node, const glm::vec3& axis, float middle, float amplitude, float period, int periods);
  /// A wheel: turns the node `turns` times about `axis`, evenly.
  void animateSpin(std::int32_t node, const glm::vec3& axis, int turns, float seconds);
  /// A closed tour: eye and target at equal time steps, smooth in between; last point = first point.
  void animateTour(std::int32_t camera, const std::vector<std::pair<glm::vec3, glm::vec3>>& stops, float seconds);

  scene::Scene take() {
    scene_.exposure = 1;  // lit for the tone map as it is
    return std::move(scene_);
  }

 private:
  scene::Scene scene_;
};

}  // namespace tyndall::levels
