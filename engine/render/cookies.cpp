#include "cookies.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <glm/gtc/packing.hpp>

#include "cookie_layers.hpp"

namespace tyndall::render {

namespace {

using scene::LightKind;
using scene::Wrap;

const scene::Image& imageOf(const scene::Scene& scene, std::int32_t texture) {
  return scene.images[static_cast<std::size_t>(scene.textures[static_cast<std::size_t>(texture)].image)];
}

CookiePlace placeOf(const scene::Scene& scene, std::int32_t texture, LightKind kind) {
  CookiePlace place;
  if (kind == LightKind::kPoint) place.faces = 6;
  if (kind != LightKind::kDirectional) return place;
  const scene::Sampler& sampler = scene.textures[static_cast<std::size_t>(texture)].sampler;
  place.repeat = {sampler.wrapU != Wrap::kClampToEdge, sampler.wrapV != Wrap::kClampToEdge};
  place.mirrored = {sampler.wrapU == Wrap::kMirroredRepeat, sampler.wrapV == Wrap::kMirroredRepeat};
  return place;
}

// Texels a side that lose nothing of the image.
std::uint32_t neededSide(const scene::Image& image, const CookiePlace& place) {
  if (place.faces == 1)
    return std::max(image.width * (place.mirrored.x ? 2 : 1), image.height * (place.mirrored.y ? 2 : 1));
  if (scene::pointCookieShape(image) == scene::CookieShape::kCubeStrip) return image.height;
  return static_cast<std::uint32_t>(std::ceil(2 * image.height / 3.14159265));
}

std::vector<Plane> layersOf(const scene::Image& image, const CookiePlace& place, std::uint32_t side) {
  const Plane plane = linearPlane(image);
  if (place.faces == 6)
    return scene::pointCookieShape(image) == scene::CookieShape::kCubeStrip ? facesFromStrip(plane, side)
                                                                            : facesFromEquirectangular(plane, side);
  const auto wrap = [](bool repeats) { return repeats ? Wrap::kRepeat : Wrap::kClampToEdge; };
  return {resized(mirroredOnce(plane, place.mirrored), side, side, wrap(place.repeat.x), wrap(place.repeat.y))};
}

Result<void> uploadLayer(gpu::Device& device, gpu::Image& image, Plane plane, std::uint32_t layer) {
  for (std::uint32_t mip = 0; mip < image.desc().mips; ++mip) {
    if (mip > 0) {
      const std::uint32_t side = std::max(1u, image.desc().width >> mip);
      plane = resized(plane, side, side, Wrap::kClampToEdge, Wrap::kClampToEdge);
    }
    std::vector<std::uint64_t> texels;
    texels.reserve(plane.texels.size());
    for (const glm::vec3& color : plane.texels) texels.push_back(glm::packHalf4x16(glm::vec4(color, 1)));
    if (auto done = device.upload(image, std::as_bytes(std::span(texels)), mip, layer); !done) return done;
  }
  return {};
}

}  // namespace

std::optional<CookiePlace> Cookies::find(const scene::Light& light) const {
  if (!light.cookie) return std::nullopt;
  const auto found = places.find({light.cookie->texture, light.kind});
  return found == places.end() ? std::nullopt : std::optional(found->second);
}

Result<Cookies> uploadCookies(gpu::Device& device, const scene::Scene& scene) {
  Cookies cookies;
  std::uint32_t layers = 0, side = 1;
  for (const scene::Light& light : scene.lights) {
    if (!light.cookie || cookies.places.contains({light.cookie->texture, light.kind})) continue;
    CookiePlace place = placeOf(scene, light.cookie->texture, light.kind);
    place.layer = layers;
    layers += place.faces;
    side = std::max(side, neededSide(imageOf(scene, light.cookie->texture), place));
    cookies.places[{light.cookie->texture, light.kind}] = place;
  }
  if (layers == 0) return cookies;
  const VkPhysicalDeviceLimits& limits = device.info().limits;
  if (layers > limits.maxImageArrayLayers)
    return failed("level: the cookies of its lights take " + std::to_string(layers) + " layers; this device takes " +
                  std::to_string(limits.maxImageArrayLayers));
  side = std::min({side, kMaxCookieSide, limits.maxImageDimension2D});
  const auto bytes = [&] { return std::uint64_t{side} * side * layers * gpu::texelBytes(kCookieFormat) * 4 / 3; };
  while (side > 16 && bytes() > kCookieBudgetBytes) side /= 2;

  gpu::ImageDesc desc;
  desc.name = "cookies";
  desc.format = kCookieFormat;
  desc.width = desc.height = side;
  desc.layers = layers;
  desc.mips = static_cast<std::uint32_t>(std::bit_width(side));
  desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  Result<gpu::Image> made = device.createImage(desc);
  if (!made) return made.error();
  cookies.image = made.take();
  for (const auto& [key, place] : cookies.places) {
    std::uint32_t layer = place.layer;
    for (Plane& plane : layersOf(imageOf(scene, key.first), place, side))
      if (auto done = uploadLayer(device, cookies.image, std::move(plane), layer++); !done) return done.error();
  }
  return cookies;
}

glm::mat4 cookieFromWorld(const scene::LightView& light, const CookiePlace& place) {
  const glm::dmat3 lightFromWorld = glm::transpose(glm::dmat3(light.worldFromLight));
  glm::dmat4 m(lightFromWorld);
  m[3] = glm::dvec4(-(lightFromWorld * glm::dvec3(light.position)), 1);
  if (place.faces == 6) return glm::mat4(m);
  glm::dmat4 cookieFromLight(0);
  if (light.light.kind == LightKind::kSpot) {
    const double slope = std::tan(double{std::min(light.light.outerConeAngle, scene::kMaxCookieAngle)});
    cookieFromLight[0][0] = cookieFromLight[1][1] = 1 / slope;
    cookieFromLight[2][2] = cookieFromLight[2][3] = -1;
  } else {
    const glm::dvec2 size(light.light.cookie->size);
    // A tile with its mirror image is twice as long, and the image's middle is at its first quarter from the upper
    // left.
    cookieFromLight[0][0] = (place.mirrored.x ? 1 : 2) / size.x;
    cookieFromLight[1][1] = (place.mirrored.y ? 1 : 2) / size.y;
    cookieFromLight[2][2] = -1;
    cookieFromLight[3] = {place.mirrored.x ? -0.5 : 0.0, place.mirrored.y ? 0.5 : 0.0, 0, 1};
  }
  return glm::mat4(cookieFromLight * m);
}

shared::CookieBlock cookieBlock(const scene::LightView& light, const Cookies& cookies) {
  shared::CookieBlock block{};
  const auto place = cookies.find(light.light);
  if (!place) return block;
  block.cookieFromWorld = cookieFromWorld(light, *place);
  block.faces = place->faces;
  block.layer = place->layer;
  block.repeats = (place->repeat.x ? 1u : 0u) | (place->repeat.y ? 2u : 0u);
  return block;
}

}  // namespace tyndall::render
