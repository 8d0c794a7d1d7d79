#include "ui/figure_scenes.h"

#include <glm/common.hpp>

#include "core/base/error.h"
#include "core/io/read_shape.h"
#include "core/report/box_faces.h"
#include "render/convert.h"
#include "render/thumbnails.h"
#include "ui/viewport_scene.h"

namespace archetype {
namespace {

glm::mat4 to_template(const FigureShape& shape) {
  glm::mat4 matrix(1);
  if (!shape.fit) return matrix;
  const Vec3 origin = shape.fit->fit.to_template(Vec3::Zero());
  for (int k = 0; k < 3; ++k)
    matrix[k] = glm::vec4(to_glm(Vec3(shape.fit->fit.to_template(Vec3::Unit(k)) - origin)), 0);
  matrix[3] = glm::vec4(to_glm(origin), 1);
  return matrix;
}

void read_faces(const Project& project, FigureShape& shape) {
  ShapeFile file = read_shape(shape.record.path);
  if (file.hash != shape.record.hash) return;  // its labels are of another file
  std::optional<std::vector<std::int16_t>> labels;
  if (shape.fit) labels = project.labels(shape.record.id);
  if (labels && labels->size() == file.mesh.element_count())
    shape.part_colours = colours_of_labels(*labels, shape.part_template.get());
  if (file.mesh.is_point_set())
    shape.points = std::make_shared<const PointGeometry>(make_point_geometry(file.mesh, shape.record.frame));
  else
    shape.mesh = std::make_shared<const MeshGeometry>(make_mesh_geometry(file.mesh, shape.record.frame));
}

// Of the part, by the order in which make_viewport_scene() adds it.
void forget_spread(Scene& scene, std::size_t part) {
  constexpr std::ptrdiff_t lines_a_part = 6;
  const auto at = static_cast<std::ptrdiff_t>(part);
  scene.ellipsoids.erase(scene.ellipsoids.begin() + at);
  const auto line = scene.lines.begin() + lines_a_part * at;
  scene.lines.erase(line, line + lines_a_part);
}

}  // namespace

std::optional<FigureShape> load_figure_shape(const Project& project, ShapeId id) {
  const auto record = project.find_shape(id);
  if (!record) return std::nullopt;
  FigureShape shape;
  shape.record = *record;
  shape.samples = project.samples(id);
  shape.fit = project.fit(id);
  std::optional<TemplateRecord> of;
  if (shape.fit) of = project.find_template(shape.fit->part_template);
  if (!of || shape.fit->fit.labels.size() != shape.samples.size()) shape.fit.reset();
  if (shape.fit) shape.part_template = std::make_shared<const PartTemplate>(std::move(of->part_template));
  try {
    read_faces(project, shape);
  } catch (const Error&) {
    // The file has gone: the samples stand for it.
  }
  if (shape.mesh || shape.points) return shape;
  shape.points = std::make_shared<const PointGeometry>(make_point_geometry(shape.samples));
  shape.part_colours.reset();
  if (shape.fit) shape.part_colours = colours_of_labels(shape.fit->fit.labels, shape.part_template.get());
  return shape;
}

void add_shape(Scene& scene, const FigureShape& shape, bool coloured) {
  const auto colours = coloured ? shape.part_colours : nullptr;
  const glm::mat4 transform = to_template(shape);
  if (shape.mesh)
    scene.meshes.push_back({.geometry = shape.mesh, .face_colours = colours, .transform = transform});
  else
    scene.points.push_back({.geometry = shape.points, .colours = colours, .transform = transform});
}

Scene template_scene(const PartTemplate& part_template, const TemplateDrawing& drawing) {
  ViewportContent content;
  content.part_template = &part_template;
  content.view.ground = false;
  content.view.spread = drawing.spread;
  content.selected = drawing.highlighted;
  content.backdrop = drawing.backdrop;
  Scene scene = make_viewport_scene(content);
  scene.hidden_lines = 0.1F;
  for (std::size_t i = part_template.parts.size(); i-- > 0;) {
    SceneBox& box = scene.boxes[i];
    box.fill = drawing.spread ? 0.42F : 0.6F;  // what tells of the spread lies within
    if (drawing.highlighted == i || !is_rare(part_template.parts[i])) continue;
    box.fill = 0;
    box.outline_width = 1;
    box.dash = 3;
    if (drawing.spread) forget_spread(scene, i);
  }
  return scene;
}

Camera figure_camera(const Scene& scene, const Viewport& viewport) {
  std::vector<glm::vec3> points;
  const auto add = [&](const std::vector<glm::vec3>& positions, const glm::mat4& transform) {
    for (const glm::vec3& position : positions) points.emplace_back(transform * glm::vec4(position, 1));
  };
  for (const SceneMesh& mesh : scene.meshes) add(mesh.geometry->positions, mesh.transform);
  for (const ScenePoints& cloud : scene.points) {
    add(cloud.geometry->positions, cloud.transform);
    add(cloud.geometry->moved, cloud.transform);  // one camera for any blend
  }
  for (const SceneBox& box : scene.boxes)
    for (int corner = 0; corner < 8; ++corner)
      points.emplace_back(to_glm(Vec3(box.box.to_world(
          Vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1)))));
  Camera camera;
  look_from(camera, ViewPreset::three_quarter);
  frame_points(camera, viewport, points, 0.03);
  return camera;
}

}  // namespace archetype
