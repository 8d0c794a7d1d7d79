// The constants that the terms of the energy leave out.
#include "core/fitting/template_choice.h"

#include <cmath>

#include "core/fitting/energy.h"
#include "core/fitting/template_surface.h"

namespace archetype {

namespace {

// Spreads of these sizes cost nothing: those of new parts, so that energies stay of the size they had.
constexpr double usual_position_stddev = 0.2;
constexpr double usual_scale_stddev = 0.1;
constexpr double usual_feature_stddev = 0.2;

double box_spread(const TemplatePart& part) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += std::log(part.position.stddev[axis] / usual_position_stddev);
    sum += std::log(part.scale.stddev[axis] / usual_scale_stddev);
  }
  return sum;
}

double mean_feature_spread(const TemplatePart& part) {
  double sum = 0;
  for (const double stddev : part.features.stddev) sum += std::log(stddev / usual_feature_stddev);
  return sum / static_cast<double>(part.features.stddev.size());
}

}  // namespace

double choice_energy(const ShapeFit& fit, const PartTemplate& part_template, const FitOptions& options) {
  const PartTemplate known = with_expected_features(part_template);
  std::vector<double> shares(known.parts.size(), 0.0);
  for (const auto label : fit.labels) {
    if (label != null_label)
      shares[static_cast<std::size_t>(label)] += 1 / static_cast<double>(fit.labels.size());
  }
  double energy = fit.energy.total() - fit.energy.deformation;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (!fit.parts[k].present) continue;
    energy += options.alpha * part_deformation(known.parts[k], fit.parts[k].box, options);
    energy += 2 * options.alpha * box_spread(known.parts[k]);
    energy += 2 * options.gamma / options.feature_clip * shares[k] * mean_feature_spread(known.parts[k]);
  }
  return energy;
}

}  // namespace archetype
