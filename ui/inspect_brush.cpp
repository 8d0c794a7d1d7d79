#include "ui/inspect_brush.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "core/base/sort_unique.h"
#include "core/session/correction_actions.h"
#include "render/picking.h"
#include "ui/studio.h"

namespace archetype {
namespace {

void apply(Studio& studio, Stage stage) {
  const Inspection& inspection = studio.inspection;
  const InspectOptions& options = studio.ui.inspect;
  const ShapeRecord& record = inspection.main.shape->record;
  const NamedShape shape{record.id, record.name};
  if (options.freeing)
    unpin_samples(studio.history, shape, sampling_of(record), inspection.stroke, stage);
  else
    pin_samples(studio.history, shape, sampling_of(record), inspection.stroke, options.paint_part, stage);
}

void drop_stroke(Inspection& inspection) {
  inspection.stroke.clear();
  inspection.stroke_previewed = false;
  inspection.stroking = false;
}

}  // namespace

std::vector<std::uint32_t> under_brush(const ShapeSamples& samples, const Vec3& point, double radius) {
  std::vector<std::uint32_t> touched;
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    if ((samples.points[i] - point).squaredNorm() <= radius * radius) touched.push_back(i);
  return touched;
}

std::vector<std::uint32_t> seen_samples(const InspectContent& content, const Camera& camera,
                                        const Viewport& viewport, const std::vector<std::uint32_t>& samples) {
  const ShapeDisplay& display = content.shape->display;
  Scene scene = make_pick_scene(content);
  // What is nearer than the sample itself by so much hides it: thinner sheets are painted on both sides.
  double slack = 0.01;
  if (!display.mesh) {
    // Splats overlap; those of the samples are few enough to look for each.
    scene.points.resize(1);
    scene.points.front().geometry = display.samples;
    scene.points.front().colours.reset();
    slack = 2.0 * static_cast<double>(display.samples->spacing);
  }
  std::vector<std::uint32_t> seen;
  for (const std::uint32_t sample : samples) {
    const glm::dvec3 at = in_scene(content.look.get(), content.shape->samples->points[sample]);
    const auto pixel = to_screen(camera, viewport, at);
    if (!pixel) continue;
    const Pick pick = pick_surface(scene, camera, viewport, *pixel);
    const double behind = pick.kind == PickKind::nothing ? 0 : glm::distance(pick.position, at);
    if (behind <= slack) seen.push_back(sample);
  }
  return seen;
}

std::vector<glm::dvec2> way_of_brush(const glm::dvec2& cursor, const glm::dvec2& moved, double radius) {
  constexpr double step_in_radii = 0.25;  // a stripe of such discs is a hundredth of its width out of true
  constexpr double least_step = 2;        // pixels
  constexpr int most_steps = 48;          // of a frame
  const double length = glm::length(moved);
  const double steps = std::ceil(length / std::max(least_step, step_in_radii * radius));
  const int count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(most_steps)));
  std::vector<glm::dvec2> way;
  for (int i = 1; i <= count; ++i) way.push_back(cursor - moved * (1 - static_cast<double>(i) / count));
  return way;
}

void paint(Studio& studio, const InspectContent& content, const Viewport& viewport,
           std::span<const InspectedPlace> way) {
  Inspection& inspection = studio.inspection;
  if (!inspection.main.shape || (inspection.stroke_previewed && !studio.history.has_preview())) {
    drop_stroke(inspection);
    return;
  }
  std::vector<std::uint32_t> under;
  for (const InspectedPlace& at : way) {
    const std::vector<std::uint32_t> touched =
        under_brush(*inspection.main.shape->samples, at.point, studio.ui.inspect.brush_radius);
    under.insert(under.end(), touched.begin(), touched.end());
    if (touched.empty()) under.push_back(at.sample);  // a small brush between the samples
  }
  sort_unique(under);
  std::vector<std::uint32_t> more;
  std::ranges::set_difference(under, inspection.stroke, std::back_inserter(more));
  const std::vector<std::uint32_t> touched = seen_samples(content, inspection.camera, viewport, more);
  std::vector<std::uint32_t> all;
  std::ranges::set_union(inspection.stroke, touched, std::back_inserter(all));
  if (all.size() == inspection.stroke.size()) return;
  inspection.stroke = std::move(all);
  apply(studio, Stage::live);
  inspection.stroke_previewed = inspection.stroke_previewed || studio.history.has_preview();
}

void end_stroke(Studio& studio) {
  Inspection& inspection = studio.inspection;
  const bool dropped = inspection.stroke_previewed && !studio.history.has_preview();
  if (inspection.main.shape && !inspection.stroke.empty() && !dropped) apply(studio, Stage::done);
  drop_stroke(inspection);
}

}  // namespace archetype
