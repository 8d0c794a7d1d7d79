#include "tests/bench/cgal_segmentation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

namespace archetype::test {

std::size_t cgal_segmentation(const PolygonMesh& mesh) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Face = Mesh::Face_index;
  Mesh surface;
  for (const Vec3& v : mesh.vertices) surface.add_vertex({v.x(), v.y(), v.z()});
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    surface.add_face(Mesh::Vertex_index(corners[0]), Mesh::Vertex_index(corners[1]),
                     Mesh::Vertex_index(corners[2]));
  }
  auto sdf = surface.add_property_map<Face, double>("f:sdf").first;
  auto segments = surface.add_property_map<Face, std::size_t>("f:segment").first;
  CGAL::sdf_values(surface, sdf);
  return CGAL::segmentation_from_sdf_values(surface, sdf, segments);
}

}  // namespace archetype::test
