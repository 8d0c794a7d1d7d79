// The scene of the viewport.
#include "ui/viewport_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/convert.h"
#include "render/thumbnails.h"
#include "ui/heat_map.h"
#include "ui/picture_marks.h"

namespace archetype {
namespace {

constexpr Rgb plain_light{196, 192, 186};
constexpr Rgb plain_dark{178, 177, 175};

Rgb plain_colour(Backdrop backdrop) {
  return backdrop == Backdrop::light ? plain_light : plain_dark;
}

glm::mat4 shape_to_scene(const ViewFit* fit) {
  glm::mat4 matrix(1);
  if (!fit) return matrix;
  const Vec3 origin = fit->fit.to_template(Vec3::Zero());
  for (int k = 0; k < 3; ++k)
    matrix[k] = glm::vec4(to_glm(Vec3(fit->fit.to_template(Vec3::Unit(k)) - origin)), 0);
  return matrix;
}

// Towards white over a dark backdrop and black over a light one, so that outlines stand out from surfaces of
// the same colour, and dark hues from the backdrop.
Rgb contrasting(const Rgb& colour, Backdrop backdrop, double share) {
  Rgb result;
  const double towards = backdrop == Backdrop::light ? 0 : 255;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround((1 - share) * colour[k] + share * towards));
  return result;
}

void add_shape(const ViewportContent& content, Scene& scene) {
  const ViewOptions& view = content.view;
  const glm::mat4 turn = shape_to_scene(content.fit);
  const bool coloured = view.colour != SurfaceColour::plain;
  const Rgb plain = plain_colour(content.backdrop);
  if (content.display.mesh && (view.surface || view.wireframe)) {
    const bool coarse = content.moving && content.display.coarse;
    SceneMesh mesh{.geometry = coarse ? content.display.coarse : content.display.mesh,
                   .colour = plain,
                   .transform = turn};
    if (coloured) mesh.face_colours = content.colours.elements;
    mesh.surface = view.surface;
    mesh.edges = view.wireframe;
    scene.meshes.push_back(std::move(mesh));
  }
  if (content.display.points && (view.surface || view.points)) {
    ScenePoints points{.geometry = content.display.points, .colour = plain, .transform = turn};
    if (coloured) points.colours = content.colours.elements;
    scene.points.push_back(std::move(points));
  }
  // Without its file a shape is still seen by its samples.
  const bool no_file = !content.display.mesh && !content.display.points;
  // Large faces have one colour each: there the samples tell more.
  const bool large_faces = content.display.mesh && content.display.samples &&
                           content.display.mesh->face_count < content.display.samples->positions.size();
  const bool heat = view.colour == SurfaceColour::cost && large_faces;
  if (content.display.samples && (view.points || no_file || heat)) {
    ScenePoints samples{.geometry = content.display.samples, .colour = plain, .transform = turn};
    if (coloured) samples.colours = content.colours.samples;
    if (view.surface && !no_file) samples.radius = 0.35F * samples.geometry->spacing;
    scene.points.push_back(std::move(samples));
  }
}

void add_average(const ViewportContent& content, Scene& scene) {
  const AverageShape& average = *content.average;
  ScenePoints ghost{.geometry = average.points, .behind = true};
  ghost.colours = content.backdrop == Backdrop::light ? average.over_light : average.over_dark;
  scene.points.push_back(ghost);
  // The shape hides most of what is behind it: what stands out of the shape is drawn before it, too.
  ghost.behind = false;
  ghost.lit = false;
  ghost.radius = 0.022F;
  scene.points.push_back(std::move(ghost));
}

bool also_selected(const ViewportContent& content, std::size_t part) {
  return std::find(content.also_selected.begin(), content.also_selected.end(), part) !=
         content.also_selected.end();
}

void add_mean_boxes(const ViewportContent& content, Scene& scene) {
  const auto& parts = content.part_template->parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    SceneBox box{.box = parts[i].mean_box(),
                 .colour = part_colour(*content.part_template, static_cast<int>(i))};
    const bool chosen = content.selected == i || also_selected(content, i);
    box.fill = chosen ? 0.24F : content.hovered == i ? 0.2F : 0.12F;
    box.outline = contrasting(box.colour, content.backdrop, chosen ? 0.65 : 0.25);
    box.outline_width = chosen ? 2.6F : content.hovered == i ? 2.2F : 1.5F;
    const bool known = content.fit && i < content.fit->fit.parts.size();
    if (known && !content.fit->fit.parts[i].present) box.dash = 6;
    scene.boxes.push_back(box);
  }
}

// As in the figures of the paper: an ellipsoid of one standard deviation of the position at the centre, and
// through the middle of each side a dashed line over one standard deviation of the half extent to either way.
void add_spread(const ViewportContent& content, Scene& scene) {
  const auto& parts = content.part_template->parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TemplatePart& part = parts[i];
    const bool chosen = content.selected == i;
    const Rgb colour = part_colour(*content.part_template, static_cast<int>(i));
    SceneEllipsoid ellipsoid{.axes = {part.position.mean, part.position.stddev}, .colour = colour};
    ellipsoid.opacity = chosen ? 0.5F : 0.3F;
    scene.ellipsoids.push_back(ellipsoid);
    for (int k = 0; k < 3; ++k)
      for (const double side : {-1.0, 1.0}) {
        const Vec3 out = part.orientation * Vec3(side * Vec3::Unit(k));
        const double inner = std::max(part.scale.mean[k] - part.scale.stddev[k], 0.0);
        SceneLine line;
        line.from = to_glm(Vec3(part.position.mean + inner * out));
        line.to = to_glm(Vec3(part.position.mean + (part.scale.mean[k] + part.scale.stddev[k]) * out));
        line.colour = contrasting(colour, content.backdrop, chosen ? 0.6 : 0.25);
        line.width = chosen ? 2.2F : 1.6F;
        line.dash = 4;
        scene.lines.push_back(line);
      }
  }
}

// Dashed and without faces: nothing to take hold of.
void add_compared_boxes(const ViewportContent& content, Scene& scene) {
  const auto& parts = content.compared->parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    SceneBox box{
        .box = parts[i].mean_box(), .colour = part_colour(*content.compared, static_cast<int>(i)), .fill = 0};
    box.outline = contrasting(box.colour, content.backdrop, 0.1);
    box.outline_width = 1.3F;
    box.dash = 4;
    scene.boxes.push_back(box);
  }
}

Rgb colour_of_fitted(const ViewFit& fit, std::size_t part) {
  const int index = static_cast<int>(part);
  return fit.part_template ? part_colour(*fit.part_template, index) : part_colour(index);
}

void add_fitted_boxes(const ViewportContent& content, Scene& scene) {
  const ShapeFit& fit = content.fit->fit;
  for (std::size_t i = 0; i < fit.parts.size(); ++i) {
    if (!fit.parts[i].present) continue;
    SceneBox box{.box = fit.parts[i].box, .colour = colour_of_fitted(*content.fit, i), .fill = 0.05F};
    box.box.centre += fit.translation;
    box.outline_width = 1.2F;
    if (content.view.mean_boxes) box.dash = 3;
    scene.boxes.push_back(box);
  }
}

}  // namespace

std::optional<std::pair<glm::dvec3, glm::dvec3>> shape_extent(const ShapeDisplay& display,
                                                              const ViewFit* fit) {
  const auto box = [&](const auto& geometry) {
    // A quarter turn about up: the corners stay corners.
    const glm::mat4 turn = shape_to_scene(fit);
    const glm::dvec3 a(turn * glm::vec4(geometry.low, 1));
    const glm::dvec3 b(turn * glm::vec4(geometry.high, 1));
    return std::pair(glm::min(a, b), glm::max(a, b));
  };
  if (display.mesh && display.mesh->triangle_count() > 0) return box(*display.mesh);
  if (display.points) return box(*display.points);
  if (display.samples) return box(*display.samples);
  return std::nullopt;
}

ShapeColours colours_of_fit(const ViewFit& fit, const ShapeDisplay& display, SurfaceColour by,
                            std::optional<int> kept) {
  ShapeColours colours;
  // While another shape is being loaded the labels may still be those of the one before.
  const std::size_t elements = display.mesh     ? display.mesh->face_count
                               : display.points ? display.points->positions.size()
                                                : 0;
  const std::size_t samples = display.samples ? display.samples->positions.size() : 0;
  const bool heat = by == SurfaceColour::cost;
  const PartTemplate* of = fit.part_template.get();
  if (elements > 0 && !heat && fit.element_labels.size() == elements)
    colours.elements = colours_of_labels(fit.element_labels, of);
  if (elements > 0 && heat && fit.element_costs.size() == elements)
    colours.elements = heat_colours(std::span(fit.element_costs));
  if (samples > 0 && !heat && fit.fit.labels.size() == samples)
    colours.samples = colours_of_labels(fit.fit.labels, of);
  if (samples > 0 && heat && fit.sample_costs.size() == samples)
    colours.samples = heat_colours(std::span(fit.sample_costs));
  if (kept && !heat) {
    colours.elements = highlighted_colours(colours.elements, fit.element_labels, *kept);
    colours.samples = highlighted_colours(colours.samples, fit.fit.labels, *kept);
  }
  return colours;
}

Scene make_viewport_scene(const ViewportContent& content) {
  Scene scene;
  scene.backdrop = content.backdrop;
  scene.grid = content.view.ground;
  if (const auto extent = shape_extent(content.display, content.fit))
    scene.ground = static_cast<float>(extent->first.y);
  if (content.average && content.view.average) add_average(content, scene);
  add_shape(content, scene);
  if (content.part_template && content.view.mean_boxes) add_mean_boxes(content, scene);
  if (content.part_template && content.view.mean_boxes && content.view.spread) add_spread(content, scene);
  if (content.compared && content.view.mean_boxes) add_compared_boxes(content, scene);
  if (content.fit && content.view.fitted_boxes) add_fitted_boxes(content, scene);
  return scene;
}

std::optional<std::pair<glm::dvec3, glm::dvec3>> extent_to_frame(const ViewportContent& content) {
  Bounds bounds;
  const auto add_box = [&](const Box& box) {
    for (int corner = 0; corner < 8; ++corner)
      bounds.add(box.to_world(
          Vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1)));
  };
  if (content.selected && content.part_template && *content.selected < content.part_template->parts.size()) {
    add_box(content.part_template->parts[*content.selected].mean_box());
    for (const std::size_t part : content.also_selected)
      if (part < content.part_template->parts.size()) add_box(content.part_template->parts[part].mean_box());
  } else {
    if (const auto extent = shape_extent(content.display, content.fit)) {
      bounds.add(to_eigen(extent->first));
      bounds.add(to_eigen(extent->second));
    }
    if (content.part_template && content.view.mean_boxes)
      for (const TemplatePart& part : content.part_template->parts) add_box(part.mean_box());
  }
  if (bounds.empty()) return std::nullopt;
  return std::pair(to_glm(bounds.low), to_glm(bounds.high));
}

}  // namespace archetype
