#include "ui/picked_place.h"

#include <algorithm>

#include "core/session/same_part.h"
#include "render/convert.h"
#include "ui/studio.h"

namespace archetype {
namespace {

const PartTemplate* template_of(const FitTable& table, TemplateId id) {
  const auto found = std::ranges::find(table.templates, id, &TemplateRecord::id);
  return found == table.templates.end() ? nullptr : &found->part_template;
}

}  // namespace

std::optional<Vec3> place_in(const FitTable& table, const PickedPlace& place, const PartTemplate& other,
                             std::size_t part) {
  const PartTemplate* of = template_of(table, place.on.part_template);
  if (!of || place.on.part >= of->parts.size()) return std::nullopt;
  const Box from = of->parts[place.on.part].mean_box();
  return other.parts[part].mean_box().to_world(from.to_local(place.canonical));
}

std::optional<glm::dvec3> picked_in_viewport(const Studio& studio) {
  const std::optional<PickedPlace>& place = studio.ui.selection.place;
  const ViewFit* view = studio.shape.fit.get();
  // A table was read where the place was picked; while boxes are edited none is read for it.
  const FitTable* table = studio.fit_tables.newest.table.get();
  if (!place || !view || !view->part_template || !studio.shape.samples || !table) return std::nullopt;
  const PartTemplate* of = template_of(*table, place->on.part_template);
  if (!of) return std::nullopt;
  const PartTemplate& fitted = *view->part_template;
  const ShapeFit& fit = view->fit;
  const auto part = find_same_part(*of, place->on.part, fitted);
  if (!part || *part >= fit.parts.size() || !fit.parts[*part].present) return std::nullopt;
  const std::optional<Vec3> on_mean = place_in(*table, *place, fitted, *part);
  if (!on_mean) return std::nullopt;
  const Vec3 wanted = fit.parts[*part].box.to_world(fitted.parts[*part].mean_box().to_local(*on_mean));
  std::optional<Vec3> nearest;
  const std::vector<Vec3>& points = studio.shape.samples->points;
  for (std::size_t i = 0; i < std::min(points.size(), fit.labels.size()); ++i) {
    if (fit.labels[i] != static_cast<int>(*part)) continue;
    const Vec3 at = fit.to_template(points[i]);
    if (!nearest || (at - wanted).squaredNorm() < (*nearest - wanted).squaredNorm()) nearest = at;
  }
  if (!nearest) return std::nullopt;
  // The viewport turns the shape as the fit does, but leaves it where it stands.
  return to_glm(Vec3(*nearest - fit.to_template(Vec3::Zero())));
}

}  // namespace archetype
