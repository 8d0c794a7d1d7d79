// Faults of meshes: flipped, duplicate, intersecting, non-manifold and degenerate faces.
#include "core/generate/faults.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/random.h"

namespace archetype {

namespace {

using Corners = std::vector<std::uint32_t>;

std::uint32_t add_vertex(PolygonMesh& mesh, const Vec3& p) {
  mesh.vertices.push_back(p);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

// The face turned by a quarter about the line from its first corner through its centre.
Corners crossing_copy(PolygonMesh& mesh, const Corners& face) {
  Vec3 centre = Vec3::Zero();
  for (const std::uint32_t corner : face) centre += mesh.vertices[corner];
  centre /= static_cast<double>(face.size());
  const Vec3 axis = (mesh.vertices[face[0]] - centre).normalized();
  Corners copy;
  for (const std::uint32_t corner : face) {
    const Vec3 arm = mesh.vertices[corner] - centre;
    const Vec3 along = arm.dot(axis) * axis;
    copy.push_back(add_vertex(mesh, centre + along + axis.cross(arm)));
  }
  return copy;
}

Corners fin(PolygonMesh& mesh, const Corners& face) {
  const Vec3 a = mesh.vertices[face[0]];
  const Vec3 b = mesh.vertices[face[1]];
  const Vec3 out = (b - a).cross(mesh.vertices[face[2]] - a).normalized();
  return {face[0], face[1], add_vertex(mesh, 0.5 * (a + b) + 0.5 * (b - a).norm() * out)};
}

}  // namespace

void add_faults(PolygonMesh& mesh, std::vector<int>& labels, const SoupFaults& faults, std::uint64_t seed) {
  RandomStream random(seed);
  PolygonMesh faulty;
  faulty.vertices = mesh.vertices;
  std::vector<int> faulty_labels;
  const auto add = [&](const Corners& face, int label) {
    faulty.add_face(face);
    faulty_labels.push_back(label);
  };
  bool turned = false;
  bool sliver = false;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const int label = labels[f];
    Corners face(mesh.face(f).begin(), mesh.face(f).end());
    if (random.uniform() < faults.flipped) std::reverse(face.begin(), face.end());
    add(face, label);
    if (random.uniform() < faults.duplicate) {
      Corners copy = face;
      if (turned) std::reverse(copy.begin(), copy.end());
      turned = !turned;
      add(copy, label);
    }
    if (random.uniform() < faults.intersecting) add(crossing_copy(faulty, face), label);
    if (random.uniform() < faults.non_manifold) add(fin(faulty, face), label);
    if (random.uniform() < faults.degenerate) {
      const Vec3 middle = 0.5 * (mesh.vertices[face[0]] + mesh.vertices[face[1]]);
      add({face[0], sliver ? add_vertex(faulty, middle) : face[0], face[1]}, label);
      sliver = !sliver;
    }
  }
  mesh = std::move(faulty);
  labels = std::move(faulty_labels);
}

}  // namespace archetype
