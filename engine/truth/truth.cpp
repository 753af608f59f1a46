#include "truth/truth.hpp"

#include <cmath>
#include <string>

#include "local_light.hpp"
#include "occluders.hpp"
#include "rows.hpp"
#include "sun.hpp"

namespace tyndall::truth {
namespace {

constexpr std::uint32_t kMaxSide = 32768;
constexpr std::uint32_t kMaxSamples = 1u << 20;

Result<void> checkRange(const char* name, double value, bool right, const char* expected) {
  if (right) return {};
  return badCall(std::string(name) + ": " + std::to_string(value) + " is out of range; it must be " + expected);
}

Result<void> check(const Settings& settings) {
  const Medium& m = settings.medium;
  const std::uint32_t side = std::max(settings.width, settings.height);
  for (const auto& result :
       {checkRange("size", side, settings.width > 0 && settings.height > 0 && side <= kMaxSide, "1 to 32768 a side"),
        checkRange("samples", settings.samples, settings.samples > 0 && settings.samples <= kMaxSamples,
                   "1 to 1048576"),
        checkRange("medium.sigma_t", m.sigma_t, std::isfinite(m.sigma_t) && m.sigma_t >= 0, "0 or more, 1/m"),
        checkRange("medium.albedo", m.albedo, m.albedo >= 0 && m.albedo <= 1, "0 to 1"),
        checkRange("medium.g", m.g, m.g > -1 && m.g < 1, "between -1 and 1"),
        checkRange("seconds", settings.seconds, std::isfinite(settings.seconds), "finite")})
    if (!result) return result;
  return {};
}

Result<void> check(const scene::CameraView& view, float far) {
  const scene::Camera& c = view.camera;
  const bool right = c.yfov > 0 && c.yfov < 3.1415926f && c.znear > 0 && far > c.znear && std::isfinite(far);
  if (right) return {};
  return failed("camera " + view.name + ": yfov " + std::to_string(c.yfov) + ", znear " + std::to_string(c.znear) +
                ", zfar " + std::to_string(far) + "; 0 < yfov < pi and 0 < znear < zfar are needed");
}

/// Unit directions through pixel centres, in world space.
class Lens {
 public:
  Lens(const scene::CameraView& view, std::uint32_t width, std::uint32_t height)
      : worldFromView_(view.worldFromView), width_(width), height_(height), up_(std::tan(view.camera.yfov / 2.0)) {}

  struct Sight {
    glm::dvec3 direction;
    double cosine;  ///< of the angle to the optical axis
  };
  Sight through(std::uint32_t x, std::uint32_t y) const {
    const double aspect = static_cast<double>(width_) / height_;
    const glm::dvec3 view((2 * (x + 0.5) / width_ - 1) * up_ * aspect, (1 - 2 * (y + 0.5) / height_) * up_, -1);
    return {glm::normalize(glm::dmat3(worldFromView_) * view), 1 / glm::length(view)};
  }
  glm::dvec3 eye() const { return glm::dvec3(worldFromView_[3]); }

 private:
  glm::dmat4 worldFromView_;
  std::uint32_t width_, height_;
  double up_;  ///< tangent of half the vertical field of view
};

struct Sun {
  glm::dvec3 travel, irradiance;
  std::optional<LightImage> image;
};
struct Lamp {
  LocalLight light;
  glm::dvec3 candela;
};

}  // namespace

Result<Picture> render(const scene::Scene& scene, const scene::CameraView& camera,
                       const std::vector<scene::LightView>& lights, const Settings& settings) {
  if (auto checked = check(settings); !checked) return checked.error();
  const scene::Bounds level =
      camera.camera.zfar ? scene::Bounds{} : scene::worldBounds(scene, scene::worldMatrices(scene, settings.seconds));
  const float farPlane = scene::farPlane(camera, level);
  if (auto checked = check(camera, farPlane); !checked) return checked.error();
  const Lens lens(camera, settings.width, settings.height);
  auto built = Occluders::build(scene, settings.seconds, lens.eye(), settings.threads);
  if (!built) return built.error();
  const Occluders& occluders = **built;

  std::vector<Sun> suns;
  std::vector<Lamp> lamps;
  for (const scene::LightView& light : lights) {
    const glm::dvec3 power = glm::dvec3(light.light.color) * double{light.light.intensity};
    if (power == glm::dvec3(0)) continue;
    if (light.light.kind == scene::LightKind::kDirectional)
      suns.push_back({glm::normalize(glm::dvec3(light.direction)), power, LightImage::of(scene, light, lens.eye())});
    else
      lamps.push_back({LocalLight(scene, light, lens.eye()), power});
  }

  const Medium& medium = settings.medium;
  const double sigma_s = medium.albedo * medium.sigma_t;
  const double zfar = farPlane;
  Picture picture{settings.width, settings.height, {}, {}};
  picture.scatter.resize(std::size_t{settings.width} * settings.height);
  picture.distance.resize(picture.scatter.size());

  const bool complete = forEachRow(settings.height, settings.threads, settings.progress, [&](std::uint32_t y) {
    ShadowRays rays(occluders);
    for (std::uint32_t x = 0; x < settings.width; ++x) {
      const auto [direction, cosine] = lens.through(x, y);
      const double far = zfar / cosine;
      const double end = occluders.firstSeen(direction, camera.camera.znear / cosine, far).value_or(far);
      glm::dvec3 radiance(0);
      if (sigma_s > 0) {
        for (const Sun& sun : suns)
          radiance += sun.irradiance * sunScatter(sun.travel, sun.image ? &*sun.image : nullptr, direction, end, medium,
                                                  occluders.bounds(), settings.samples, rays);
        for (const Lamp& lamp : lamps)
          radiance += lamp.candela * lamp.light.scatter(direction, end, medium, settings.samples, rays);
      }
      const std::size_t pixel = std::size_t{y} * settings.width + x;
      picture.scatter[pixel] =
          glm::vec4(glm::vec3(sigma_s * radiance), static_cast<float>(std::exp(-medium.sigma_t * end)));
      picture.distance[pixel] = static_cast<float>(end);
    }
  });
  if (!complete) return failed("truth: cancelled");
  return picture;
}

}  // namespace tyndall::truth
