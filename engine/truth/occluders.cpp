#include "occluders.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tyndall::truth {
namespace {

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

Occluders::~Occluders() {
  if (tree_) rtcReleaseScene(tree_);
  if (device_) rtcReleaseDevice(device_);
}

Result<std::unique_ptr<Occluders>> Occluders::build(const scene::Scene& scene, double seconds, const glm::dvec3& eye,
                                                    unsigned threads) {
  std::unique_ptr<Occluders> occluders(new Occluders);
  const std::string options = threads ? "threads=" + std::to_string(threads) : "";
  occluders->device_ = rtcNewDevice(options.c_str());
  if (!occluders->device_)
    return failed("Embree gives no device (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
  occluders->tree_ = rtcNewScene(occluders->device_);
  rtcSetSceneFlags(occluders->tree_, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(occluders->tree_, RTC_BUILD_QUALITY_HIGH);

  const std::vector<glm::mat4> worldFromNode = scene::worldMatrices(scene, seconds);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const scene::Node& node = scene.nodes[n];
    if (node.mesh == scene::kNone) continue;
    glm::dmat4 eyeFromMesh(worldFromNode[n]);
    eyeFromMesh[3] -= glm::dvec4(eye, 0);
    for (const scene::Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives)
      if (!occluders->add(scene, primitive, eyeFromMesh, node.castsShadow))
        return failed("node " + std::to_string(n) + (node.name.empty() ? "" : " (" + node.name + ")") +
                      ": its mesh does not fit: a vertex is at no finite place, or memory ran out");
  }
  rtcCommitScene(occluders->tree_);
  if (const RTCError error = rtcGetDeviceError(occluders->device_); error != RTC_ERROR_NONE)
    return failed("Embree cannot build its tree (error " + std::to_string(error) +
                  (error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory)" : ")"));
  return occluders;
}

bool Occluders::add(const scene::Scene& scene, const scene::Primitive& primitive, const glm::dmat4& eyeFromMesh,
                    bool casts) {
  static const scene::Material kDefault;
  const scene::Material& material =
      primitive.material == scene::kNone ? kDefault : scene.materials[static_cast<std::size_t>(primitive.material)];
  if (material.alphaMode == scene::AlphaMode::kBlend || primitive.indices.empty()) return true;

  Surface& surface = surfaces_.emplace_back();
  surface.singleSided = !material.doubleSided;
  surface.casts = casts && material.castsShadow;
  if (material.alphaMode == scene::AlphaMode::kMask) surface.mask.emplace(scene, primitive, material);

  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::unique_ptr<RTCGeometryTy, void (*)(RTCGeometry)> owner(geometry, rtcReleaseGeometry);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), primitive.vertices.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), primitive.indices.size() / 3));
  if (!vertices || !indices) return false;
  for (const scene::Vertex& vertex : primitive.vertices) {
    const glm::dvec3 p(eyeFromMesh * glm::dvec4(vertex.position, 1));
    const glm::vec3 rounded(p);
    if (!finite(rounded)) return false;
    for (int k = 0; k < 3; ++k) *vertices++ = rounded[k];
    bounds_.min = glm::min(bounds_.min, glm::dvec3(rounded));
    bounds_.max = glm::max(bounds_.max, glm::dvec3(rounded));
  }
  std::copy(primitive.indices.begin(), primitive.indices.end(), indices);
  // A mirroring node turns the winding round (glTF 2.0, 3.7.4). The side is kept by the surface, not by swapping
  // corners, so that barycentric weights still belong to the primitive's own corners.
  surface.mirrored = glm::determinant(glm::dmat3(eyeFromMesh)) < 0;

  rtcSetGeometryUserData(geometry, &surface);
  if (surface.singleSided || surface.mask) rtcSetGeometryIntersectFilterFunction(geometry, filterSeen);
  if (surface.mask || !surface.casts) rtcSetGeometryOccludedFilterFunction(geometry, filterShadow);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(tree_, geometry);
  return true;
}

void Occluders::filterSeen(const RTCFilterFunctionNArguments* arguments) {
  const auto& surface = *static_cast<const Surface*>(arguments->geometryUserPtr);
  const unsigned n = arguments->N;
  for (unsigned i = 0; i < n; ++i) {
    if (arguments->valid[i] == 0) continue;
    const glm::dvec3 normal(RTCHitN_Ng_x(arguments->hit, n, i), RTCHitN_Ng_y(arguments->hit, n, i),
                            RTCHitN_Ng_z(arguments->hit, n, i));
    const glm::dvec3 direction(RTCRayN_dir_x(arguments->ray, n, i), RTCRayN_dir_y(arguments->ray, n, i),
                               RTCRayN_dir_z(arguments->ray, n, i));
    const bool front = (glm::dot(normal, direction) < 0) != surface.mirrored;
    const bool seen = front || !surface.singleSided;
    if (!seen || (surface.mask &&
                  !surface.mask->covers(RTCHitN_primID(arguments->hit, n, i), double{RTCHitN_u(arguments->hit, n, i)},
                                        double{RTCHitN_v(arguments->hit, n, i)})))
      arguments->valid[i] = 0;
  }
}

void Occluders::filterShadow(const RTCFilterFunctionNArguments* arguments) {
  const auto& surface = *static_cast<const Surface*>(arguments->geometryUserPtr);
  const unsigned n = arguments->N;
  for (unsigned i = 0; i < n; ++i)
    if (arguments->valid[i] != 0 && !surface.casts)
      arguments->valid[i] = 0;
    else if (arguments->valid[i] != 0 &&
             !surface.mask->covers(RTCHitN_primID(arguments->hit, n, i), double{RTCHitN_u(arguments->hit, n, i)},
                                   double{RTCHitN_v(arguments->hit, n, i)}))
      arguments->valid[i] = 0;
}

std::optional<double> Occluders::firstSeen(const glm::dvec3& direction, double near, double far) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  const glm::vec3 d(direction);
  query.ray.dir_x = d.x, query.ray.dir_y = d.y, query.ray.dir_z = d.z;
  query.ray.tnear = static_cast<float>(near);
  query.ray.tfar = static_cast<float>(far);
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tree_, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return double{query.ray.tfar};
}

}  // namespace tyndall::truth
