// From a polygon soup or point set to what is drawn.
#include "render/geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "render/convert.h"

namespace archetype {
namespace {

// Far outliers of hostile files must not become infinite in single precision.
glm::vec3 to_scene(const ShapeFrame& frame, const Vec3& p) {
  return glm::vec3(glm::clamp(to_glm(frame.to_normalised(p)), -1e18, 1e18));
}

void set_bounds(const std::vector<glm::vec3>& positions, glm::vec3& low, glm::vec3& high) {
  if (positions.empty()) return;
  low = high = positions.front();
  for (const glm::vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge make_edge(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Edge> sorted_edges(std::span<const std::uint32_t> face) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < face.size(); ++i)
    edges.push_back(make_edge(face[i], face[(i + 1) % face.size()]));
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Vertices at the same place get the same number, so that soups with a vertex of their own for each face are
// smoothed as well.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const glm::vec3& p = positions[a];
    const glm::vec3& q = positions[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    return p.z != q.z ? p.z < q.z : a < b;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> welded(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

// A corner's normal is the mean of those of the triangles that meet there and bend by less than the crease
// angle from its own, each turned to its side and weighted by its area.
void smooth_normals(const Triangulation& triangulation, const std::vector<glm::vec3>& vertices, double crease,
                    MeshGeometry& geometry) {
  const auto& triangles = triangulation.triangles;
  std::vector<glm::vec3> area_vectors(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const glm::dvec3 a = geometry.positions[3 * t];
    area_vectors[t] = glm::vec3(glm::cross(glm::dvec3(geometry.positions[3 * t + 1]) - a,
                                           glm::dvec3(geometry.positions[3 * t + 2]) - a));
  }
  // The triangles about each welded vertex, as slices of one list.
  const std::vector<std::uint32_t> welded = weld(vertices);
  std::vector<std::uint32_t> begins(vertices.size() + 1, 0);
  for (const auto& triangle : triangles)
    for (const std::uint32_t v : triangle) ++begins[welded[v] + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<std::uint32_t> about(3 * triangles.size());
  std::vector<std::uint32_t> filled(begins.begin(), begins.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t v : triangles[t]) about[filled[welded[v]]++] = t;

  // A hub where thousands of triangles meet would cost the square of their number; its neighbours by file
  // order do.
  constexpr std::uint32_t most_neighbours = 64;
  const float least_cosine = static_cast<float>(std::cos(crease));
  geometry.normals.resize(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const float area = glm::length(area_vectors[t]);
    const glm::vec3 own = area > 0 ? area_vectors[t] / area : glm::vec3(0, 1, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = welded[triangles[t][k]];
      glm::vec3 sum(0);
      for (std::uint32_t i = begins[v]; i < std::min(begins[v + 1], begins[v] + most_neighbours); ++i) {
        const glm::vec3& other = area_vectors[about[i]];
        const float cosine = glm::dot(own, other);
        if (std::abs(cosine) >= least_cosine * glm::length(other)) sum += cosine < 0 ? -other : other;
      }
      const float length = glm::length(sum);
      geometry.normals[3 * t + k] = length > 0 ? sum / length : own;
    }
  }
}

// The mean distance to the nearest of the other points if n points lay evenly on the surface of the bounding
// box.
float typical_spacing(const glm::vec3& low, const glm::vec3& high, std::size_t n) {
  const glm::vec3 s = high - low;
  const float area = 2 * (s.x * s.y + s.y * s.z + s.z * s.x);
  return std::sqrt(area / static_cast<float>(std::max<std::size_t>(n, 1)));
}

}  // namespace

MeshGeometry make_mesh_geometry(const PolygonMesh& mesh, const ShapeFrame& frame, double crease) {
  std::vector<glm::vec3> vertices(mesh.vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = to_scene(frame, mesh.vertices[v]);

  MeshGeometry geometry;
  Triangulation triangulation = triangulate(mesh);
  geometry.face_count = mesh.face_count();
  geometry.positions.reserve(3 * triangulation.triangles.size());
  geometry.edge_distances.reserve(3 * triangulation.triangles.size());
  std::vector<Edge> face_edges;  // of the face of the triangle before
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    const auto& corners = triangulation.triangles[t];
    if (t == 0 || triangulation.faces[t] != triangulation.faces[t - 1])
      face_edges = sorted_edges(mesh.face(triangulation.faces[t]));
    glm::u8vec4 hidden(0);
    for (int k = 0; k < 3; ++k) {
      const std::size_t next = static_cast<std::size_t>(k + 1) % 3;
      const std::size_t after = static_cast<std::size_t>(k + 2) % 3;
      const Edge side = make_edge(corners[next], corners[after]);
      if (!std::binary_search(face_edges.begin(), face_edges.end(), side)) hidden[k] = 255;
    }
    for (int k = 0; k < 3; ++k) {
      geometry.positions.push_back(vertices[corners[static_cast<std::size_t>(k)]]);
      glm::u8vec4 distance = hidden;
      distance[k] = 255;
      geometry.edge_distances.push_back(distance);
    }
  }
  smooth_normals(triangulation, vertices, crease, geometry);
  geometry.faces = std::move(triangulation.faces);
  set_bounds(geometry.positions, geometry.low, geometry.high);
  return geometry;
}

PointGeometry make_point_geometry(const PolygonMesh& mesh, const ShapeFrame& frame) {
  PointGeometry geometry;
  geometry.positions.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) geometry.positions.push_back(to_scene(frame, p));
  for (const Vec3& n : mesh.point_normals) geometry.normals.emplace_back(to_glm(Vec3(frame.rotation * n)));
  set_bounds(geometry.positions, geometry.low, geometry.high);
  geometry.spacing = typical_spacing(geometry.low, geometry.high, geometry.positions.size());
  return geometry;
}

PointGeometry make_point_geometry(const ShapeSamples& samples) {
  PointGeometry geometry;
  for (const Vec3& p : samples.points) geometry.positions.emplace_back(to_glm(p));
  for (const Vec3& n : samples.normals) geometry.normals.emplace_back(to_glm(n));
  set_bounds(geometry.positions, geometry.low, geometry.high);
  geometry.spacing = typical_spacing(geometry.low, geometry.high, geometry.positions.size());
  return geometry;
}

}  // namespace archetype
