// A polygon soup or a point set, as it stood in the file.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/geometry/vector.h"

namespace archetype {

// Faces are kept in file order, whatever their topology: duplicate, degenerate (fewer than three corners,
// equal corners, no area) and non-manifold ones included, since labels are written per face of the file. A
// shape without faces is a point set; its vertices are what labels are written for.
struct PolygonMesh {
  std::vector<Vec3> vertices;  // file coordinates
  std::vector<std::uint32_t>
      face_corners;  // vertex indices, all faces one after the other; each < vertices.size()
  std::vector<std::uint32_t> face_begins{0};  // face_count() + 1 offsets into face_corners
  std::vector<Vec3> point_normals;            // empty, or one unit (or zero) vector per vertex of a point set

  std::size_t face_count() const { return face_begins.size() - 1; }
  bool is_point_set() const { return face_count() == 0; }
  // Labels per file: one per face, or per point of a point set.
  std::size_t element_count() const { return is_point_set() ? vertices.size() : face_count(); }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(face_corners).subspan(face_begins[f], face_begins[f + 1] - face_begins[f]);
  }
  void add_face(std::span<const std::uint32_t> corners) {
    face_corners.insert(face_corners.end(), corners.begin(), corners.end());
    face_begins.push_back(static_cast<std::uint32_t>(face_corners.size()));
  }
};

// Newell's vector of a face: along its normal, twice its area long, also for polygons that are not flat; zero
// for degenerate faces.
Vec3 face_area_vector(const PolygonMesh& mesh, std::size_t face);

// Mean of the corners; zero for a face without corners.
Vec3 face_centre(const PolygonMesh& mesh, std::size_t face);

Bounds bounds(const PolygonMesh& mesh);

// Triangles of the soup with the face that each came from. A quad that is not convex and every larger face is
// cut by ear clipping in its own plane; faces without area give no triangle.
struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> faces;  // the file's face of each triangle
};
Triangulation triangulate(const PolygonMesh& mesh);

}  // namespace archetype
