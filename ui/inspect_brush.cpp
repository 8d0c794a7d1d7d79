#include "ui/inspect_brush.h"

#include <algorithm>

#include "core/session/correction_actions.h"
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

void paint(Studio& studio, const std::optional<InspectedPlace>& at) {
  Inspection& inspection = studio.inspection;
  if (!inspection.main.shape || (inspection.stroke_previewed && !studio.history.has_preview())) {
    drop_stroke(inspection);
    return;
  }
  if (!at || at->side != 0) return;
  std::vector<std::uint32_t> touched =
      under_brush(*inspection.main.shape->samples, at->point, studio.ui.inspect.brush_radius);
  if (touched.empty()) touched.push_back(at->sample);  // a small brush between the samples
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
