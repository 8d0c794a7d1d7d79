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

// Of the samples, by part.
std::vector<double> label_shares(const ShapeFit& fit) {
  std::vector<double> shares(fit.parts.size(), 0.0);
  for (const auto label : fit.labels) {
    if (label != null_label)
      shares[static_cast<std::size_t>(label)] += 1 / static_cast<double>(fit.labels.size());
  }
  return shares;
}

// How well the data terms tell where the two sides of each part across each axis lie, in 1 / units^2 / alpha:
// those samples of the shape and of the template that lie on them pull at the centre and the half extent
// alike, those on other sides slide along. 0 for absent parts.
std::vector<Vec3> precisions(const ShapeFit& fit, const std::vector<double>& shares, double unit,
                             const FitOptions& options) {
  std::vector<Vec3> sides(fit.parts.size(), Vec3::Zero());
  double area = 0;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (!fit.parts[k].present) continue;
    const Vec3& half = fit.parts[k].box.half_extent;
    sides[k] = {half.y() * half.z(), half.x() * half.z(), half.x() * half.y()};
    area += sides[k].sum();
  }
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (!fit.parts[k].present) continue;
    const double samples = shares[k] + sides[k].sum() / area;  // equations 3 and 4
    sides[k] *= samples / (sides[k].sum() * unit * unit * options.alpha);
  }
  return sides;
}

double box_spread(const TemplatePart& part, const Vec3& precision) {
  const auto cost = [](double w, double stddev, double usual) {
    return std::log((1 + w * stddev * stddev) / (1 + w * usual * usual));
  };
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum += cost(precision[axis], part.position.stddev[axis], usual_position_stddev);
    sum += cost(precision[axis], part.scale.stddev[axis], usual_scale_stddev);
  }
  return sum;
}

double mean_feature_spread(const TemplatePart& part) {
  double sum = 0;
  for (const double stddev : part.features.stddev) sum += std::log(stddev / usual_feature_stddev);
  return sum / static_cast<double>(part.features.stddev.size());
}

}  // namespace

double choice_energy(const ShapeFit& fit, const PartTemplate& part_template, const ShapeSamples& samples,
                     const FitOptions& options) {
  const PartTemplate known = with_expected_features(part_template);
  const std::vector<double> shares = label_shares(fit);
  const auto precision = precisions(fit, shares, options.distance_unit * samples.radius, options);
  double energy = fit.energy.total() - fit.energy.deformation;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (!fit.parts[k].present) continue;
    energy += options.alpha * part_deformation(known.parts[k], fit.parts[k].box, options);
    energy += options.alpha * box_spread(known.parts[k], precision[k]);
    energy += 2 * options.gamma / options.feature_clip * shares[k] * mean_feature_spread(known.parts[k]);
  }
  return energy;
}

}  // namespace archetype
