// Small pictures of shapes.
#include "render/thumbnails.h"

#include <algorithm>
#include <cmath>

namespace archetype {
namespace {

constexpr double margin = 0.06;

// How far beyond the edge of the picture the points come: 1 is the edge.
double reach(const Camera& camera, const Viewport& size, std::span<const glm::vec3> points) {
  double most = 0;
  for (const glm::vec3& point : points)
    if (const auto at = to_screen(camera, size, point))
      most = std::max({most, std::abs(2 * at->x / size.width - 1), std::abs(2 * at->y / size.height - 1)});
  return most;
}

Picture draw_thumbnail(Renderer& renderer, Scene scene, const std::vector<glm::vec3>& positions,
                       const ThumbnailOptions& options) {
  scene.backdrop = options.backdrop;
  RenderTarget target;
  renderer.draw(scene, shape_camera(positions, options), {options.size, options.size, options.mask ? 1 : 2},
                target);
  return target.read();
}

}  // namespace

Camera thumbnail_camera(std::span<const glm::vec3> framed, Viewport size) {
  Camera camera;
  look_from(camera, ViewPreset::three_quarter);
  frame_points(camera, size, framed, margin);
  return camera;
}

Camera shape_camera(const std::vector<glm::vec3>& positions, const ThumbnailOptions& options) {
  std::vector<glm::vec3> placed;
  placed.reserve(positions.size());
  for (const glm::vec3& position : positions) placed.emplace_back(options.transform * glm::vec4(position, 1));
  const Viewport size{options.size, options.size};
  Camera camera = thumbnail_camera(options.framed.empty() ? placed : options.framed, size);
  if (options.framed.empty()) return camera;
  if (const double beyond = reach(camera, size, placed); beyond > 1) camera.distance *= beyond * (1 + margin);
  return camera;
}

Picture mesh_thumbnail(Renderer& renderer, const std::shared_ptr<const MeshGeometry>& geometry,
                       std::shared_ptr<const Colours> face_colours, const ThumbnailOptions& options) {
  Scene scene;
  scene.meshes.push_back({.geometry = geometry,
                          .face_colours = std::move(face_colours),
                          .lit = !options.mask,
                          .transform = options.transform});
  return draw_thumbnail(renderer, std::move(scene), geometry->positions, options);
}

Picture point_thumbnail(Renderer& renderer, const std::shared_ptr<const PointGeometry>& geometry,
                        std::shared_ptr<const Colours> colours, const ThumbnailOptions& options) {
  Scene scene;
  scene.points.push_back({.geometry = geometry,
                          .colours = std::move(colours),
                          .lit = !options.mask,
                          .transform = options.transform});
  return draw_thumbnail(renderer, std::move(scene), geometry->positions, options);
}

std::shared_ptr<const Colours> colours_of_labels(std::span<const std::int16_t> labels,
                                                 const PartTemplate* part_template) {
  auto colours = std::make_shared<Colours>();
  colours->reserve(labels.size());
  for (const std::int16_t label : labels)
    colours->push_back(part_template ? part_colour(*part_template, label) : part_colour(label));
  return colours;
}

}  // namespace archetype
