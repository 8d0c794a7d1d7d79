// Shapes in the form that is drawn and picked: made once, shared by all views that show the shape.
#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/geometry/polygon_mesh.h"
#include "core/geometry/shape_frame.h"
#include "core/model/shape.h"
#include "render/triangle_tree.h"

namespace archetype {

// Triangles, each with three corners of its own: faces have their own colours and soups share few corners
// anyway.
struct MeshGeometry {
  std::vector<glm::vec3> positions;  // three per triangle
  // Per corner, unit, on the side of the triangle that its corners run around counter-clockwise. Soups are
  // not oriented: drawing turns them to the viewer.
  std::vector<glm::vec3> normals;
  // Per corner, for drawing edges: barycentric coordinates (0 or 255), with 255 at all three corners for the
  // side that is no edge of the file's face.
  std::vector<glm::u8vec4> edge_distances;
  std::vector<std::uint32_t> faces;  // per triangle, the face of the file that it is a part of
  std::size_t face_count = 0;        // of the file
  TriangleTree
      tree;  // over `positions`; empty unless surfaces are picked, since it costs as much as the rest
  glm::vec3 low{0}, high{0};  // bounds

  std::size_t triangle_count() const { return faces.size(); }
};

struct PointGeometry {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  // empty, or one per point; their sign has no meaning
  std::vector<glm::vec3> moved;    // empty, or where each point comes to by ScenePoints::blend
  float spacing = 0;               // a typical distance of neighbours, for the size of the splats
  glm::vec3 low{0}, high{0};
};

// `frame` takes the file's coordinates to those of the scene; this happens in double precision, so that
// shapes far from their origin keep their detail. Corners are smoothed over edges that bend by less than
// `crease` (radians). About 1 µs per triangle; needs no OpenGL, so it may run in a job.
MeshGeometry make_mesh_geometry(const PolygonMesh& mesh, const ShapeFrame& frame, double crease = 0.7);

// The points of a point set, or the vertices of a mesh.
PointGeometry make_point_geometry(const PolygonMesh& mesh, const ShapeFrame& frame);
PointGeometry make_point_geometry(const ShapeSamples& samples);

}  // namespace archetype
