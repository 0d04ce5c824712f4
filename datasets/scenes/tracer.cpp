#include "datasets/scenes/tracer.h"

#include <embree3/rtcore.h>

#include <limits>
#include <string>

#include "datasets/error.h"

namespace warplut::scenes {
namespace {

struct CutOutMesh {
  const Mesh* mesh = nullptr;
  const World* world = nullptr;
};

// Refuses hits in the holes of cut-out materials.
void FilterCutOut(const RTCFilterFunctionNArguments* args) {
  const auto& cut = *static_cast<const CutOutMesh*>(args->geometryUserPtr);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    const Material& material = cut.world->materials[cut.mesh->materials[triangle]];
    if (!material.CutOut()) continue;
    const float u = RTCHitN_u(args->hit, args->N, i), v = RTCHitN_v(args->hit, args->N, i);
    const auto& t = cut.mesh->triangles[triangle];
    const auto& uvs = cut.mesh->uvs;
    const Vec2f uv = (1 - u - v) * uvs[t[0]] + u * uvs[t[1]] + v * uvs[t[2]];
    if (!Covers(material, uv)) args->valid[i] = 0;
  }
}

}  // namespace

struct Tracer::State {
  const World* world = nullptr;
  RTCDevice device = nullptr;
  std::vector<RTCScene> meshes;
  std::vector<CutOutMesh> cut_outs;

  ~State() {
    for (RTCScene scene : meshes) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

Tracer::Tracer(const World& world) : state_(std::make_unique<State>()) {
  state_->world = &world;
  state_->device = rtcNewDevice(nullptr);
  if (state_->device == nullptr) {
    throw Error("scene renderer: Embree refused to start with error " +
                std::to_string(static_cast<int>(rtcGetDeviceError(nullptr))) +
                ", expected a ray tracing device");
  }
  state_->cut_outs.resize(world.meshes.size());
  for (std::size_t m = 0; m < world.meshes.size(); ++m) {
    const Mesh& mesh = world.meshes[m];
    RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.positions.size()));
    for (const Vec3f& p : mesh.positions) vertices = std::copy_n(p.data(), 3, vertices);
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& t : mesh.triangles) indices = std::copy_n(t.data(), 3, indices);
    const bool cut_out = std::any_of(mesh.materials.begin(), mesh.materials.end(),
                                     [&](int id) { return world.materials[id].CutOut(); });
    if (cut_out) {
      state_->cut_outs[m] = {&mesh, &world};
      rtcSetGeometryUserData(geometry, &state_->cut_outs[m]);
      rtcSetGeometryIntersectFilterFunction(geometry, FilterCutOut);
      rtcSetGeometryOccludedFilterFunction(geometry, FilterCutOut);
    }
    rtcCommitGeometry(geometry);
    RTCScene scene = rtcNewScene(state_->device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    state_->meshes.push_back(scene);
  }
}

Tracer::~Tracer() = default;

struct Tracer::Moment::State {
  RTCScene scene = nullptr;
  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
  }
};

Tracer::Moment::Moment(const Tracer& tracer, const std::vector<Transform>& transforms)
    : state_(std::make_unique<State>()) {
  const Tracer::State& shared = *tracer.state_;
  state_->scene = rtcNewScene(shared.device);
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    RTCGeometry instance = rtcNewGeometry(shared.device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, shared.meshes[shared.world->objects[i].mesh]);
    const Eigen::Matrix<float, 3, 4> matrix = transforms[i].matrix().topRows<3>().cast<float>();
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix.data());
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(state_->scene, instance, static_cast<unsigned>(i));
    rtcReleaseGeometry(instance);
  }
  rtcCommitScene(state_->scene);
}

Tracer::Moment::~Moment() = default;

Hit Tracer::Moment::Intersect(const Vec3d& origin, const Vec3d& direction, float from) const {
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin.x());
  query.ray.org_y = static_cast<float>(origin.y());
  query.ray.org_z = static_cast<float>(origin.z());
  query.ray.dir_x = static_cast<float>(direction.x());
  query.ray.dir_y = static_cast<float>(direction.y());
  query.ray.dir_z = static_cast<float>(direction.z());
  query.ray.tnear = from;
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0U;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(state_->scene, &context, &query);
  Hit hit;
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
  hit.object = static_cast<int>(query.hit.instID[0]);
  hit.triangle = static_cast<int>(query.hit.primID);
  hit.u = query.hit.u;
  hit.v = query.hit.v;
  hit.distance = query.ray.tfar;
  return hit;
}

bool Tracer::Moment::Occluded(const Vec3f& origin, const Vec3f& direction) const {
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0U;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(state_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace warplut::scenes
