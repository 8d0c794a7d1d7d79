// Areas, normals and triangles of polygon soups.
#include "core/geometry/polygon_mesh.h"

#include <Eigen/Geometry>
#include <numeric>

namespace archetype {

namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool inside(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

// The corners in the plane of the face, counter-clockwise, scaled to its size.
std::vector<Vec2> flatten(const PolygonMesh& mesh, std::span<const std::uint32_t> corners, const Vec3& area) {
  const Vec3 normal = area.normalized();
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const auto c : corners) {
    const Vec3 d = mesh.vertices[c] - mesh.vertices[corners[0]];
    flat.emplace_back(d.dot(u), d.dot(v));
  }
  return flat;
}

// Ear clipping (Meisters 1975), O(n^2) for each ear; polygons with more corners than this become fans, so
// that a hostile file with one huge face cannot stop the program.
constexpr std::size_t max_ear_clip_corners = 2000;

void clip_ears(const std::vector<Vec2>& flat, std::span<const std::uint32_t> corners, std::uint32_t face,
               Triangulation& out) {
  std::vector<std::size_t> ring(corners.size());
  std::iota(ring.begin(), ring.end(), std::size_t{0});
  const auto emit = [&](std::size_t a, std::size_t b, std::size_t c) {
    out.triangles.push_back({corners[a], corners[b], corners[c]});
    out.faces.push_back(face);
  };
  std::size_t at = 0;
  std::size_t misses = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    const std::size_t a = ring[at % n];
    const std::size_t b = ring[(at + 1) % n];
    const std::size_t c = ring[(at + 2) % n];
    bool ear = cross(flat[a], flat[b], flat[c]) > 0;
    for (std::size_t i = 3; ear && i < n; ++i) {
      const Vec2& p = flat[ring[(at + i) % n]];
      ear = !inside(p, flat[a], flat[b], flat[c]) || p == flat[a] || p == flat[b] || p == flat[c];
    }
    // A polygon that crosses itself may have no ear: cut anywhere then, rather than never end.
    if (ear || misses >= n) {
      emit(a, b, c);
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>((at + 1) % n));
      misses = 0;
    } else {
      ++at;
      ++misses;
    }
    at %= ring.size();
  }
  emit(ring[0], ring[1], ring[2]);
}

}  // namespace

Vec3 face_area_vector(const PolygonMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  if (corners.size() < 3) return sum;
  const Vec3& origin = mesh.vertices[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (mesh.vertices[corners[i]] - origin).cross(mesh.vertices[corners[i + 1]] - origin);
  }
  return sum;
}

Vec3 face_centre(const PolygonMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  for (const auto c : corners) sum += mesh.vertices[c];
  return corners.empty() ? sum : Vec3(sum / static_cast<double>(corners.size()));
}

Bounds bounds(const PolygonMesh& mesh) {
  Bounds result;
  for (const Vec3& v : mesh.vertices) result.add(v);
  return result;
}

Triangulation triangulate(const PolygonMesh& mesh) {
  Triangulation out;
  out.triangles.reserve(mesh.face_corners.size());
  out.faces.reserve(mesh.face_corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    const auto face = static_cast<std::uint32_t>(f);
    const Vec3 area = face_area_vector(mesh, f);
    if (corners.size() < 3 || !(area.squaredNorm() > 0)) continue;
    if (corners.size() == 3) {
      out.triangles.push_back({corners[0], corners[1], corners[2]});
      out.faces.push_back(face);
    } else if (corners.size() <= max_ear_clip_corners) {
      clip_ears(flatten(mesh, corners, area), corners, face, out);
    } else {
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        out.triangles.push_back({corners[0], corners[i], corners[i + 1]});
        out.faces.push_back(face);
      }
    }
  }
  return out;
}

}  // namespace archetype
