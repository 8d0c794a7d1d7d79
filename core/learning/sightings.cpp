// One fit a shape.
#include "core/learning/sightings.h"

#include "core/base/parallel.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/settle_boxes.h"
#include "core/fitting/template_choice.h"

namespace archetype {

namespace {

// Differs from the paper in that some of the prior stays: a part of few samples would become anything.
constexpr double kept_prior = 0.1;
constexpr double loosest_stddev = 0.2;
constexpr int steps = 5;

// d*(t, s) of section 4.2: the boxes that minimise E_data for the labels of the fit. Those of the fit itself
// lie nearer to the means than the shape's parts do, and spreads estimated from them would shrink with every
// round.
std::vector<Box> free_boxes(const PartTemplate& part_template, const ShapeSamples& samples,
                            const ShapeFit& fit, const FitOptions& options) {
  PartTemplate loose = part_template;
  for (TemplatePart& part : loose.parts) {
    part.position.stddev = part.position.stddev.cwiseMax(loosest_stddev);
    part.scale.stddev = part.scale.stddev.cwiseMax(loosest_stddev);
  }
  FitOptions loosened = options;
  loosened.alpha *= kept_prior;
  return settle_boxes(loose, samples, fit, loosened, steps);
}

}  // namespace

std::optional<std::vector<Sighting>> sightings(const PartTemplate& part_template,
                                               std::span<const LearningShape> shapes,
                                               const FitOptions& options, unsigned threads,
                                               const JobControl& control) {
  std::vector<Sighting> result(shapes.size());
  const bool all = parallel_for(shapes.size(), threads, control, "learning", [&](std::size_t i) {
    const ShapeSamples& samples = *shapes[i].samples;
    FitOptions shape_options = options;
    shape_options.yaw_costs = shapes[i].yaw_costs;
    std::vector<PinnedLabel> pinned;
    if (shapes[i].correction)
      pinned = pinned_labels(shapes[i].correction->pinned, part_template, samples.size());
    const auto fit = fit_template(part_template, samples, shape_options, {control.stop, {}}, nullptr, pinned);
    if (!fit) return;
    Sighting& seen = result[i];
    seen.choice = choice_energy(*fit, part_template, samples, options) +
                  shape_options.yaw_costs[static_cast<std::size_t>(fit->yaw_quarters)];
    seen.yaw_energies = fit->yaw_energies;
    seen.yaw_quarters = fit->yaw_quarters;
    seen.energy = fit->energy.total();
    seen.misfit = fit->energy.data();
    for (const Vec3& p : samples.points) seen.bounds.add(fit->to_template(p));
    seen.parts = observe_parts(*fit, samples);
    const std::vector<Box> boxes = free_boxes(part_template, samples, *fit, options);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (seen.parts[k].present) seen.parts[k].box = boxes[k];
    }
  });
  if (!all || control.cancelled()) return std::nullopt;
  return result;
}

}  // namespace archetype
