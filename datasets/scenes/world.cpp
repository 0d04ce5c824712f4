#include "datasets/scenes/world.h"

namespace warplut::scenes {

int World::AddMaterial(const Material& material) {
  materials.push_back(material);
  return static_cast<int>(materials.size() - 1);
}

int World::AddSign(const std::string& lines, const Rgb& ground, const Rgb& ink, float texel) {
  texts.push_back(std::make_unique<const Text>(lines));
  Material sign{.pattern = Pattern::kSign, .a = ground, .b = ink, .size = texel};
  sign.text = texts.back().get();
  return AddMaterial(sign);
}

int World::AddMesh(Mesh mesh) {
  meshes.push_back(std::move(mesh));
  return static_cast<int>(meshes.size() - 1);
}

void World::Place(int mesh, const Transform& placement) {
  objects.push_back({mesh, placement, {}});
}

void World::Place(int mesh, const Transform& placement, std::function<Transform(double)> motion) {
  objects.push_back({mesh, placement, std::move(motion)});
}

Vec2f World::SignSize(int material) const {
  const Material& sign = materials.at(material);
  return Vec2f(static_cast<float>(sign.text->width()), static_cast<float>(sign.text->height())) *
         sign.size;
}

}  // namespace warplut::scenes
