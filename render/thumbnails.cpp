// Small pictures of shapes.
#include "render/thumbnails.h"

namespace archetype {
namespace {

Picture draw_thumbnail(Renderer& renderer, Scene scene, const std::vector<glm::vec3>& positions,
                       const ThumbnailOptions& options) {
  Camera camera;
  look_from(camera, ViewPreset::three_quarter);
  frame_points(camera, {options.size, options.size}, positions, 0.06);
  scene.backdrop = options.backdrop;
  RenderTarget target;
  renderer.draw(scene, camera, {options.size, options.size, 2}, target);
  return target.read();
}

}  // namespace

Picture mesh_thumbnail(Renderer& renderer, const std::shared_ptr<const MeshGeometry>& geometry,
                       std::shared_ptr<const Colours> face_colours, const ThumbnailOptions& options) {
  Scene scene;
  scene.meshes.push_back({.geometry = geometry, .face_colours = std::move(face_colours)});
  return draw_thumbnail(renderer, std::move(scene), geometry->positions, options);
}

Picture point_thumbnail(Renderer& renderer, const std::shared_ptr<const PointGeometry>& geometry,
                        std::shared_ptr<const Colours> colours, const ThumbnailOptions& options) {
  Scene scene;
  scene.points.push_back({.geometry = geometry, .colours = std::move(colours)});
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
