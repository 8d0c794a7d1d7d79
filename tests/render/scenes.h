// Scenes that several tests draw.
#pragma once

#include <array>
#include <filesystem>
#include <memory>

#include "core/base/picture.h"
#include "core/base/random.h"
#include "render/camera.h"
#include "render/scene.h"

namespace archetype {

inline std::filesystem::path shader_folder() {
  return std::filesystem::path(ARCHETYPE_SOURCE_DIR) / "shaders";
}

inline void add_triangle(PolygonMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.add_face(std::array{first, first + 1, first + 2});
}

// A soup of n triangles that cut through each other, of any orientation.
inline PolygonMesh random_soup(std::size_t n, std::uint64_t seed) {
  RandomStream random(seed);
  const auto within = [&](double r) {
    return Vec3(random.uniform(-r, r), random.uniform(-r, r), random.uniform(-r, r));
  };
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 middle = within(1);
    add_triangle(mesh, middle + within(0.4), middle + within(0.4), middle + within(0.4));
  }
  return mesh;
}

// The square [-1, 1]^2 at height z, as one face.
inline PolygonMesh square(double z) {
  PolygonMesh mesh;
  mesh.vertices = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
  mesh.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  return mesh;
}

inline std::shared_ptr<const MeshGeometry> geometry_of(const PolygonMesh& mesh) {
  MeshGeometry geometry = make_mesh_geometry(mesh, ShapeFrame{});
  geometry.tree = TriangleTree(geometry.positions);
  return std::make_shared<MeshGeometry>(std::move(geometry));
}

inline Rgb pixel_of(const Picture& picture, int x, int y) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(x));
  return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

inline int alpha_of(const Picture& picture, int x, int y) {
  return picture.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(x)) +
                        3];
}

}  // namespace archetype
