// Edges in buckets of their ends.
#include "core/geometry/face_adjacency.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace archetype {

namespace {

// For every vertex the first one at the same place.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices) {
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3& p = vertices[a];
    const Vec3& q = vertices[b];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.z() != q.z()) return p.z() < q.z();
    return a < b;
  };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

// Kept with its lower vertex.
struct Edge {
  std::uint32_t higher;
  std::uint32_t face;
  bool forward;  // the face runs from the lower to the higher vertex
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    parent_[std::max(find(a), find(b))] = std::min(find(a), find(b));
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

FaceAdjacency find_adjacent_faces(const PolygonMesh& mesh) {
  const std::vector<std::uint32_t> first = weld(mesh.vertices);
  // Edges in buckets of their lower vertex, then in the order of the higher one and of the faces.
  std::vector<std::uint32_t> begins(mesh.vertices.size() + 1, 0);
  const auto for_each_edge = [&](const auto& visit) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      const auto corners = mesh.face(f);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = first[corners[i]];
        const std::uint32_t b = first[corners[i + 1 < corners.size() ? i + 1 : 0]];
        if (a != b) visit(std::min(a, b), Edge{std::max(a, b), f, a < b});
      }
    }
  };
  for_each_edge([&](std::uint32_t lower, const Edge&) { ++begins[lower + 1]; });
  for (std::size_t v = 0; v + 1 < begins.size(); ++v) begins[v + 1] += begins[v];
  std::vector<Edge> edges(begins.back());
  std::vector<std::uint32_t> at(begins.begin(), begins.end() - 1);
  for_each_edge([&](std::uint32_t lower, const Edge& edge) { edges[at[lower]++] = edge; });

  std::vector<Vec3> normals(mesh.face_count());
  std::vector<Vec3> centres(mesh.face_count());
  const Vec3 origin = mesh.vertices.empty() ? Vec3::Zero() : mesh.vertices.front();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    normals[f] = face_area_vector(mesh, f);
    centres[f] = face_centre(mesh, f);
  }

  struct Shared {
    FacePair pair;
    bool wound_alike;
  };
  std::vector<Shared> shared;
  DisjointSets components(mesh.face_count());
  std::size_t distinct = 0;
  for (std::uint32_t v = 0; v + 1 < begins.size(); ++v) {
    const auto bucket = std::span(edges).subspan(begins[v], begins[v + 1] - begins[v]);
    std::sort(bucket.begin(), bucket.end(), [](const Edge& x, const Edge& y) {
      return x.higher != y.higher ? x.higher < y.higher : x.face < y.face;
    });
    for (std::size_t i = 0; i < bucket.size();) {
      std::size_t end = i + 1;
      while (end < bucket.size() && bucket[end].higher == bucket[i].higher) ++end;
      ++distinct;
      if (end - i == 2 && bucket[i].face != bucket[i + 1].face) {
        const double length = (mesh.vertices[v] - mesh.vertices[bucket[i].higher]).norm();
        const bool alike = bucket[i].forward != bucket[i + 1].forward;
        shared.push_back({{bucket[i].face, bucket[i + 1].face, length, 0, 0, false}, alike});
        if (alike) components.join(bucket[i].face, bucket[i + 1].face);
      }
      i = end;
    }
  }
  // The volume's sign tells for each component whether its normals point outward.
  std::vector<double> volume(mesh.face_count(), 0.0);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    volume[components.find(f)] += normals[f].dot(centres[f] - origin);
  }
  FaceAdjacency result;
  result.pairs.reserve(shared.size());
  result.shared_share =
      distinct == 0 ? 0 : static_cast<double>(shared.size()) / static_cast<double>(distinct);
  for (auto& [pair, alike] : shared) {
    const Vec3 a = normals[pair.a].normalized();
    const Vec3 b = normals[pair.b].normalized();
    const double cosine = alike ? a.dot(b) : std::abs(a.dot(b));
    pair.across = (centres[pair.b] - centres[pair.a]).norm();
    pair.angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double outward = volume[components.find(pair.a)] < 0 ? -1.0 : 1.0;
    pair.convex = alike && outward * a.dot(centres[pair.b] - centres[pair.a]) <= 0;
    result.pairs.push_back(pair);
  }
  return result;
}

std::vector<std::uint32_t> face_components(const PolygonMesh& mesh) {
  const std::vector<std::uint32_t> first = weld(mesh.vertices);
  DisjointSets sets(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    for (const std::uint32_t corner : mesh.face(f)) sets.join(first[mesh.face(f)[0]], first[corner]);
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number_of_set(mesh.vertices.size(), none);
  std::vector<std::uint32_t> components(mesh.face_count());
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).empty()) {
      components[f] = count++;  // a face without corners hangs together with nothing
      continue;
    }
    std::uint32_t& number = number_of_set[sets.find(first[mesh.face(f)[0]])];
    if (number == none) number = count++;
    components[f] = number;
  }
  return components;
}

}  // namespace archetype
