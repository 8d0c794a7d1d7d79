// Decimation by OpenMesh, which shows nowhere but here.
#include "core/geometry/decimate.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <numeric>

namespace archetype {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using Decimater = OpenMesh::Decimater::DecimaterT<TriMesh>;

class StopObserver : public OpenMesh::Decimater::Observer {
 public:
  explicit StopObserver(const JobControl& control) : Observer(500), control_(control) {}
  void notify(std::size_t) override {}
  bool abort() const override { return control_.cancelled(); }

 private:
  const JobControl& control_;
};

OpenMesh::Vec3d to_openmesh(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// The first vertex at the place of each: soups often have a vertex of their own for each corner.
std::vector<std::uint32_t> first_at_same_place(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](std::uint32_t v) {
    return std::array{vertices[v].x(), vertices[v].y(), vertices[v].z(), double(v)};
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && vertices[order[i]] == vertices[order[i - 1]] ? first[order[i - 1]] : order[i];
  return first;
}

// The faces of OpenMesh's mesh are the triangles that have an area, in their order; `sources` says which.
TriMesh to_trimesh(const PolygonMesh& mesh, const Triangulation& triangulation,
                   std::vector<std::uint32_t>& sources) {
  // It writes to standard error what add_face() tells by its result as well.
  static const bool quiet = [] {
    omerr().disable();
    return true;
  }();
  static_cast<void>(quiet);
  TriMesh result;
  for (const Vec3& vertex : mesh.vertices) result.add_vertex(to_openmesh(vertex));
  const std::vector<std::uint32_t> welded = first_at_same_place(mesh.vertices);
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    std::array<TriMesh::VertexHandle, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = TriMesh::VertexHandle(static_cast<int>(welded[triangulation.triangles[t][k]]));
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    if (!result.add_face(corners[0], corners[1], corners[2]).is_valid()) {
      for (TriMesh::VertexHandle& corner : corners) {
        const OpenMesh::Vec3d point = result.point(corner);  // a copy: adding may move all points
        corner = result.add_vertex(point);
      }
      result.add_face(corners[0], corners[1], corners[2]);
    }
    sources.push_back(triangulation.faces[t]);
  }
  return result;
}

DecimatedMesh to_decimated(const TriMesh& mesh, const std::vector<std::uint32_t>& sources) {
  DecimatedMesh result;
  std::vector<std::uint32_t> number(mesh.n_vertices(), UINT32_MAX);
  for (const auto face : mesh.all_faces()) {
    if (mesh.status(face).deleted()) continue;
    std::vector<std::uint32_t> corners;
    for (const auto vertex : mesh.fv_range(face)) {
      std::uint32_t& known = number[static_cast<std::size_t>(vertex.idx())];
      if (known == UINT32_MAX) {
        known = static_cast<std::uint32_t>(result.mesh.vertices.size());
        const OpenMesh::Vec3d& p = mesh.point(vertex);
        result.mesh.vertices.emplace_back(p[0], p[1], p[2]);
      }
      corners.push_back(known);
    }
    result.mesh.add_face(corners);
    result.faces.push_back(sources[static_cast<std::size_t>(face.idx())]);
  }
  return result;
}

}  // namespace

std::optional<DecimatedMesh> decimate(const PolygonMesh& mesh, std::size_t triangle_count,
                                      const JobControl& control) {
  std::vector<std::uint32_t> sources;
  TriMesh coarse = to_trimesh(mesh, triangulate(mesh), sources);
  if (control.cancelled()) return std::nullopt;
  coarse.request_face_normals();
  coarse.request_vertex_status();
  coarse.request_edge_status();
  coarse.request_halfedge_status();
  coarse.request_face_status();
  coarse.update_face_normals();

  Decimater decimater(coarse);
  OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<TriMesh>::Handle no_flips;
  decimater.add(quadric);
  decimater.add(no_flips);
  decimater.module(quadric).unset_max_err();
  StopObserver observer(control);
  decimater.set_observer(&observer);
  if (!decimater.initialize()) return std::nullopt;
  decimater.decimate_to_faces(0, triangle_count);
  if (control.cancelled()) return std::nullopt;
  return to_decimated(coarse, sources);
}

}  // namespace archetype
