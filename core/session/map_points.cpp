// Loads both shapes and carries the points over.
#include "core/session/map_points.h"

#include "core/base/error.h"
#include "core/evaluation/surface_map.h"
#include "core/session/read_imported.h"

namespace archetype {

namespace {

struct Side {
  ShapeRecord shape;
  PolygonMesh mesh;
  ShapeFit fit;
  PartTemplate part_template;
  std::vector<std::int16_t> labels;

  LabelledSurface surface() const { return {mesh, shape.frame, fit, labels}; }
};

Side load(const Project& project, const std::string& name) {
  const std::optional<ShapeRecord> shape = project.find_shape(name);
  if (!shape) {
    throw FileError(project.path(), "has no shape " + name +
                                        "; shapes are named by their path in the imported folder without "
                                        "its ending, with __ for /");
  }
  std::optional<FitRecord> fit = project.fit(shape->id);
  std::optional<std::vector<std::int16_t>> labels = project.labels(shape->id);
  if (!fit || !labels) {
    throw FileError(project.path(), "has no labelled fit of " + name + "; run `archetype fit` first");
  }
  return {*shape, read_imported(*shape), std::move(fit->fit),
          project.find_template(fit->part_template).value().part_template, std::move(*labels)};
}

}  // namespace

std::vector<std::optional<MappedPoint>> map_points(const Project& project, const std::string& from,
                                                   const std::string& to, std::span<const Vec3> points) {
  const Side source = load(project, from);
  const Side target = load(project, to);
  const SurfaceToTemplate to_template(source.surface(), source.part_template);
  const TemplateToSurface to_surface(target.surface(), target.part_template);
  std::vector<std::optional<MappedPoint>> mapped(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::optional<PartPoint> place = to_template.locate(points[i]);
    if (!place) continue;
    place->part = counterpart(source.part_template, place->part, target.part_template);
    if (const auto found = to_surface.find(*place)) mapped[i] = MappedPoint{found->position, found->part};
  }
  return mapped;
}

}  // namespace archetype
