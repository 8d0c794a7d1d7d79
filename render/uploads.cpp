// Upload of geometry and colours.
#include "render/uploads.h"

#include "core/base/error.h"

namespace archetype {
namespace {

// The inputs of mesh.vert and points.vert.
constexpr int position_input = 0;
constexpr int normal_input = 1;
constexpr int mesh_edge_input = 2;
constexpr int mesh_colour_input = 3;
constexpr int point_colour_input = 2;
constexpr int point_moved_input = 3;

glm::u8vec4 opaque(const Rgb& colour) {
  return {colour[0], colour[1], colour[2], 255};
}

gl::Attribute vectors(int location) {
  return {location, 3, gl::Component::float32, sizeof(glm::vec3), 0, false};
}
gl::Attribute bytes(int location) {
  return {location, 4, gl::Component::unorm8, sizeof(glm::u8vec4), 0, false};
}

UploadedColours upload(const std::vector<glm::u8vec4>& colours) {
  UploadedColours upload;
  upload.colours.upload(std::span(colours));
  return upload;
}

UploadedColours upload_face_colours(const SceneMesh& mesh) {
  const MeshGeometry& geometry = *mesh.geometry;
  if (mesh.face_colours->size() != geometry.face_count)
    throw PreconditionError("a mesh needs one colour per face of its file");
  std::vector<glm::u8vec4> corners;
  corners.reserve(3 * geometry.triangle_count());
  for (const std::uint32_t face : geometry.faces)
    corners.insert(corners.end(), 3, opaque((*mesh.face_colours)[face]));
  return upload(corners);
}

UploadedColours upload_point_colours(const ScenePoints& points) {
  if (points.colours->size() != points.geometry->positions.size())
    throw PreconditionError("a point cloud needs one colour per point");
  std::vector<glm::u8vec4> colours;
  for (const Rgb& colour : *points.colours) colours.push_back(opaque(colour));
  return upload(colours);
}

}  // namespace

const gl::VertexArray& Uploads::mesh(const SceneMesh& mesh) {
  UploadedGeometry& uploaded = geometry_.get(mesh.geometry, nullptr, [&] {
    UploadedGeometry made;
    made.positions.upload(std::span(mesh.geometry->positions));
    made.normals.upload(std::span(mesh.geometry->normals));
    made.edge_distances.upload(std::span(mesh.geometry->edge_distances));
    made.vertices.attach(made.positions, vectors(position_input));
    made.vertices.attach(made.normals, vectors(normal_input));
    made.vertices.attach(made.edge_distances, bytes(mesh_edge_input));
    return made;
  });
  // The same geometry may be drawn with other colours in the same picture: they are attached anew each time.
  if (mesh.face_colours) {
    const auto& colours =
        colours_.get(mesh.face_colours, mesh.geometry, [&] { return upload_face_colours(mesh); });
    uploaded.vertices.attach(colours.colours, bytes(mesh_colour_input));
  } else {
    uploaded.vertices.detach(mesh_colour_input);
  }
  return uploaded.vertices;
}

const gl::VertexArray& Uploads::points(const ScenePoints& points) {
  UploadedGeometry& uploaded = geometry_.get(points.geometry, nullptr, [&] {
    UploadedGeometry made;
    made.positions.upload(std::span(points.geometry->positions));
    made.vertices.attach(made.positions, vectors(position_input));
    if (!points.geometry->normals.empty()) {
      made.normals.upload(std::span(points.geometry->normals));
      made.vertices.attach(made.normals, vectors(normal_input));
    }
    if (!points.geometry->moved.empty()) {
      made.moved.upload(std::span(points.geometry->moved));
      made.vertices.attach(made.moved, vectors(point_moved_input));
    }
    return made;
  });
  if (points.colours) {
    const auto& colours =
        colours_.get(points.colours, points.geometry, [&] { return upload_point_colours(points); });
    uploaded.vertices.attach(colours.colours, bytes(point_colour_input));
  } else {
    uploaded.vertices.detach(point_colour_input);
  }
  return uploaded.vertices;
}

void Uploads::end_picture() {
  geometry_.end_round();
  colours_.end_round();
}

}  // namespace archetype
