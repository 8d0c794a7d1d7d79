#include "ui/inspect_scene.h"

#include <algorithm>
#include <glm/common.hpp>
#include <span>

#include "render/convert.h"
#include "render/thumbnails.h"
#include "ui/heat_map.h"
#include "ui/painted_surface.h"
#include "ui/picture_marks.h"

namespace archetype {
namespace {

constexpr Rgb plain_colour{186, 184, 180};

glm::mat4 to_scene(const FitLook* look) {
  glm::mat4 matrix(1);
  if (!look) return matrix;
  const Vec3 origin = look->fit.to_template(Vec3::Zero());
  for (int k = 0; k < 3; ++k)
    matrix[k] = glm::vec4(to_glm(Vec3(look->fit.to_template(Vec3::Unit(k)) - origin)), 0);
  matrix[3] = glm::vec4(to_glm(origin), 1);
  return matrix;
}

Rgb colour_of(const FitLook& look, std::size_t part) {
  return part_colour(*look.part_template, static_cast<int>(part));
}

bool is_chosen(const InspectContent& content, std::size_t part) {
  return !content.part || *content.part == part;
}

void add_shape(const InspectContent& content, Scene& scene) {
  const ShapeDisplay& display = content.shape->display;
  const glm::mat4 turn = to_scene(content.look.get());
  if (display.mesh)
    scene.meshes.push_back({.geometry = display.mesh,
                            .face_colours = content.colours.elements,
                            .colour = plain_colour,
                            .transform = turn});
  if (display.points)
    scene.points.push_back({.geometry = display.points,
                            .colours = content.colours.elements,
                            .colour = plain_colour,
                            .transform = turn});
  const bool no_file = !display.mesh && !display.points;
  if (display.samples && (content.options.samples || no_file)) {
    ScenePoints samples{.geometry = display.samples,
                        .colours = content.colours.samples,
                        .colour = plain_colour,
                        .transform = turn};
    if (!no_file) samples.radius = 0.4F * display.samples->spacing;
    scene.points.push_back(std::move(samples));
  }
}

// What was painted, in the colours of the parts that it was given: smooth on a surface; on a point set a ball
// for each sample, larger than it.
void add_pinned(const InspectContent& content, Scene& scene) {
  if (content.pinned.empty() || !content.look || !content.shape->display.samples) return;
  if (const auto& mesh = content.shape->display.mesh) {
    for (PaintedPatch& patch : painted_patches(*mesh, *content.shape->display.samples, content.pinned))
      scene.meshes.push_back({.geometry = std::move(patch.geometry),
                              .colour = part_colour(*content.look->part_template, patch.label),
                              .transform = to_scene(content.look.get())});
    return;
  }
  auto geometry = std::make_shared<PointGeometry>();
  auto colours = std::make_shared<Colours>();
  const PointGeometry& samples = *content.shape->display.samples;
  for (const PinnedLabel& pin : content.pinned) {
    geometry->positions.push_back(samples.positions[pin.sample]);
    colours->push_back(part_colour(*content.look->part_template, pin.label));
  }
  geometry->spacing = samples.spacing;
  geometry->low = samples.low;
  geometry->high = samples.high;
  scene.points.push_back({.geometry = std::move(geometry),
                          .colours = std::move(colours),
                          .radius = 0.75F * samples.spacing,
                          .lit = false,
                          .transform = to_scene(content.look.get())});
}

void add_boxes(const InspectContent& content, Scene& scene) {
  const FitLook& look = *content.look;
  for (std::size_t i = 0; i < look.fit.parts.size(); ++i) {
    if (!is_chosen(content, i)) continue;
    const Rgb colour = colour_of(look, i);
    if (content.options.fitted_boxes && look.fit.parts[i].present)
      scene.boxes.push_back({.box = look.fit.parts[i].box, .colour = colour, .fill = 0.08F});
    if (content.options.mean_boxes)
      scene.boxes.push_back({.box = look.part_template->parts[i].mean_box(),
                             .colour = colour,
                             .fill = 0,
                             .outline_width = 1.3F,
                             .dash = 5});
  }
}

void add_template_points(const InspectContent& content, Scene& scene) {
  const FitLook& look = *content.look;
  auto geometry = std::make_shared<PointGeometry>();
  auto colours = std::make_shared<Colours>();
  for (const FitInspection::TemplatePoint& point : look.terms.template_points) {
    if (!is_chosen(content, static_cast<std::size_t>(point.part))) continue;
    geometry->positions.push_back(to_glm(point.position));
    colours->push_back(heat_colour(point.distance / largest_heat));
  }
  if (geometry->positions.empty()) return;
  geometry->low = geometry->high = geometry->positions.front();
  for (const glm::vec3& p : geometry->positions) {
    geometry->low = glm::min(geometry->low, p);
    geometry->high = glm::max(geometry->high, p);
  }
  geometry->spacing = 0.05F;
  scene.points.push_back(
      {.geometry = std::move(geometry), .colours = std::move(colours), .radius = 0.018F, .lit = false});
}

// From each sample to the box, thin, and from each point of the box to the sample, stronger.
void add_correspondences(const InspectContent& content, Scene& scene) {
  const FitLook& look = *content.look;
  const auto& points = content.shape->samples->points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int16_t label = look.fit.labels[i];
    if (label == null_label || !is_chosen(content, static_cast<std::size_t>(label))) continue;
    scene.lines.push_back({.from = to_glm(look.fit.to_template(points[i])),
                           .to = to_glm(look.terms.on_template[i]),
                           .colour = colour_of(look, static_cast<std::size_t>(label)),
                           .opacity = 0.7F,
                           .width = 1});
  }
  for (const FitInspection::TemplatePoint& point : look.terms.template_points) {
    const auto part = static_cast<std::size_t>(point.part);
    if (!is_chosen(content, part)) continue;
    scene.lines.push_back({.from = to_glm(point.position),
                           .to = to_glm(look.fit.to_template(points[point.sample])),
                           .colour = colour_of(look, part),
                           .opacity = 0.9F,
                           .width = 1.5F});
  }
}

}  // namespace

ShapeColours inspect_colours(const FitLook& look, InspectColour by, std::optional<std::size_t> kept) {
  ShapeColours colours;
  const auto heat = [&](std::size_t term, const std::vector<double>& samples) {
    if (!look.element_terms[term].empty())
      colours.elements = heat_colours(std::span<const float>(look.element_terms[term]));
    colours.samples = heat_colours(std::span<const double>(samples));
  };
  switch (by) {
    case InspectColour::plain:
      break;
    case InspectColour::part:
      if (!look.element_labels.empty())
        colours.elements = colours_of_labels(look.element_labels, look.part_template.get());
      colours.samples = colours_of_labels(look.fit.labels, look.part_template.get());
      if (kept) {
        const int part = static_cast<int>(*kept);
        colours.elements = highlighted_colours(colours.elements, look.element_labels, part);
        colours.samples = highlighted_colours(colours.samples, look.fit.labels, part);
      }
      break;
    case InspectColour::shape_to_template:
      heat(0, look.terms.shape_to_template);
      break;
    case InspectColour::features:
      heat(1, look.terms.features);
      break;
    case InspectColour::smoothness:
      heat(2, look.terms.smoothness);
      break;
  }
  return colours;
}

Scene make_inspect_scene(const InspectContent& content) {
  Scene scene;
  scene.backdrop = content.backdrop;
  scene.grid = true;
  const ShapeDisplay& display = content.shape->display;
  const bool has_mesh = display.mesh && display.mesh->triangle_count() > 0;
  const glm::dvec3 lowest = has_mesh ? display.mesh->low : display.samples->low;
  scene.ground = static_cast<float>(in_scene(content.look.get(), to_eigen(lowest)).y);  // turns are about up
  add_shape(content, scene);
  if (!content.look) return scene;
  add_pinned(content, scene);
  add_boxes(content, scene);
  if (content.options.template_points) add_template_points(content, scene);
  if (content.options.correspondences) add_correspondences(content, scene);
  return scene;
}

Scene make_pick_scene(const InspectContent& content) {
  InspectContent only = content;
  only.options.samples = false;
  Scene scene;
  add_shape(only, scene);
  return scene;
}

glm::dvec3 in_scene(const FitLook* look, const Vec3& point) {
  return to_glm(look ? look->fit.to_template(point) : point);
}

Vec3 on_shape(const FitLook* look, const glm::dvec3& point) {
  return look ? look->fit.to_shape(to_eigen(point)) : to_eigen(point);
}

std::vector<glm::vec3> inspected_points(const InspectContent& content) {
  std::vector<glm::vec3> points;
  for (const Vec3& point : content.shape->samples->points)
    points.emplace_back(in_scene(content.look.get(), point));
  if (!content.look) return points;
  for (const FittedPart& part : content.look->fit.parts) {
    if (!part.present) continue;
    for (int corner = 0; corner < 8; ++corner)
      points.emplace_back(to_glm(part.box.to_world(
          {(corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0})));
  }
  return points;
}

}  // namespace archetype
