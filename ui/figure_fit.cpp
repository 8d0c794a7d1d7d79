// One fit in four pictures.
#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "render/convert.h"
#include "render/thumbnails.h"
#include "ui/figure.h"
#include "ui/figure_scenes.h"

namespace archetype {
namespace {

constexpr double margin = 16;
constexpr double gap = 12;
constexpr double text = 15;
constexpr double small_text = 12;

// Of all points, those that a line is drawn for: more could not be told apart.
constexpr std::size_t most_lines = 160;

void add_correspondences(Scene& scene, const FigureShape& shape) {
  const ShapeFit& fit = shape.fit->fit;
  const std::size_t step = std::max<std::size_t>(1, shape.samples.size() / most_lines);
  auto ends = std::make_shared<PointGeometry>();
  auto colours = std::make_shared<Colours>();
  for (std::size_t i = 0; i < shape.samples.size(); i += step) {
    if (fit.labels[i] == null_label) continue;
    const auto part = static_cast<std::size_t>(fit.labels[i]);
    const Vec3 q = fit.to_template(shape.samples.points[i]);
    const Vec3 match = closest_on_surface(fit.parts[part].box, q);
    const Vec3 home = shape.part_template->parts[part].mean_box().to_world(match);
    const Rgb colour = part_colour(*shape.part_template, fit.labels[i]);
    SceneLine line;
    line.from = to_glm(q);
    line.to = to_glm(home);
    line.colour = colour;
    line.width = 1.2F;
    scene.lines.push_back(line);
    for (const Vec3& p : {q, home}) {
      ends->positions.emplace_back(to_glm(p));
      colours->push_back(colour);
    }
  }
  if (ends->positions.empty()) return;
  ends->low = ends->high = ends->positions.front();
  for (const glm::vec3& p : ends->positions) {
    ends->low = glm::min(ends->low, p);
    ends->high = glm::max(ends->high, p);
  }
  ends->spacing = 0.035F;
  scene.points.push_back({.geometry = ends, .colours = colours});
}

void add_boxes(Scene& scene, const FigureShape& shape, bool fitted, bool mean) {
  const ShapeFit& fit = shape.fit->fit;
  for (std::size_t i = 0; i < fit.parts.size(); ++i) {
    const Rgb colour = part_colour(*shape.part_template, static_cast<int>(i));
    if (fitted && fit.parts[i].present)
      scene.boxes.push_back({.box = fit.parts[i].box, .colour = colour, .fill = 0.14F});
    if (mean)
      scene.boxes.push_back({.box = shape.part_template->parts[i].mean_box(),
                             .colour = colour,
                             .fill = fitted ? 0.F : 0.06F,
                             .outline_width = 1.1F,
                             .dash = 4});
  }
}

}  // namespace

std::optional<Picture> fit_figure(const FigureRequest& request, const JobControl& control) {
  if (request.shapes.empty()) throw Error("no shape is in view; click one in the collection first");
  const Project project = Project::open(request.project);
  const auto shape = load_figure_shape(project, request.shapes.front());
  if (!shape) throw Error("the shape is not in the project any more");
  if (!shape->fit)
    throw Error(shape->record.name + " is not fitted yet; fit a template to all shapes, or learn, first");
  Scene plain;
  add_shape(plain, *shape, false);
  Scene parts;
  add_shape(parts, *shape, true);
  Scene boxes = parts;
  add_boxes(boxes, *shape, true, true);
  Scene matches;
  add_correspondences(matches, *shape);
  add_boxes(matches, *shape, false, true);
  const std::array<std::pair<const Scene*, const char*>, 4> panels{
      std::pair(&plain, "Shape"), std::pair(&parts, "Parts found"),
      std::pair(&boxes, "Fitted boxes, and mean boxes dashed"),
      std::pair(&matches, "Correspondences with the mean boxes")};
  FigurePage page(request);
  constexpr double width = (1000 - 2 * margin - gap) / 2;
  constexpr double height = 0.8 * width;
  constexpr double row = height + text + gap;
  page.set_height(2 * margin + 2 * row + small_text + gap);
  // One camera for all, so that they can be compared.
  const Camera camera = figure_camera(boxes, page.viewport(width, height));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t above = i / 2;
    const double left = margin + static_cast<double>(i % 2) * (width + gap);
    const double top = margin + static_cast<double>(above) * row;
    if (!page.draw_scene(*panels[i].first, camera, left, top, width, height, control)) return std::nullopt;
    page.write(panels[i].second, left, top + height, text, FigurePage::Style::bold, width);
  }
  char line[160];
  const FitEnergy& energy = shape->fit->fit.energy;
  std::snprintf(line, sizeof line,
                "energy %.3f: distances and features %.3f, deformation %.3f, smoothness %.3f, parts %.3f",
                energy.total(), energy.data(), energy.deformation, energy.smoothness, energy.existence);
  page.write(shape->record.name + ", by " + shape->part_template->name + "; " + line, margin,
             margin + 2 * row + gap / 2, small_text, FigurePage::Style::muted, 1000 - 2 * margin);
  return page.picture();
}

}  // namespace archetype
