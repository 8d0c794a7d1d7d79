// Geometry for the shape in view.
#include "ui/shape_display.h"

#include "core/geometry/decimate.h"

namespace archetype {

std::optional<ShapeDisplay> make_shape_display(const ShapeDisplayRequest& request,
                                               const JobControl& control) {
  ShapeDisplay display;
  display.shape_revision = request.shape_revision;
  if (request.samples)
    display.samples = std::make_shared<const PointGeometry>(make_point_geometry(*request.samples));
  if (request.mesh && request.mesh->is_point_set())
    display.points = std::make_shared<const PointGeometry>(make_point_geometry(*request.mesh, request.frame));
  else if (request.mesh)
    display.mesh = std::make_shared<const MeshGeometry>(make_mesh_geometry(*request.mesh, request.frame));
  if (control.cancelled()) return std::nullopt;
  return display;
}

std::optional<CoarseMesh> make_coarse_mesh(const ShapeDisplayRequest& request, const JobControl& control) {
  const auto decimated = decimate(*request.mesh, request.most_moving / 2, control);
  if (!decimated) return std::nullopt;
  MeshGeometry geometry = make_mesh_geometry(decimated->mesh, request.frame);
  for (std::uint32_t& face : geometry.faces) face = decimated->faces[face];
  geometry.face_count = request.mesh->face_count();
  return CoarseMesh{std::make_shared<const MeshGeometry>(std::move(geometry)), request.shape_revision};
}

}  // namespace archetype
