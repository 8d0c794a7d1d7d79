// Logarithms of ratios of variances.
#include "core/learning/parameter_cost.h"

#include <algorithm>
#include <cmath>

namespace archetype {

namespace {

// Up to which a fit tells where a side of a box lies, in normalised units: no mean is known more exactly.
constexpr double told_variance = 0.055 * 0.055;

double cost_of_means(const Gaussian3& found, const Gaussian3& known, double shapes) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double before = shapes * known.stddev[axis] * known.stddev[axis];
    const double variance = found.stddev[axis] * found.stddev[axis] + told_variance;
    const double moved = found.mean[axis] - known.mean[axis];
    sum += std::log1p(before / variance) + shapes * moved * moved / (before + variance);
  }
  return sum;
}

}  // namespace

double parameter_cost(const PartTemplate& part_template, const PartTemplate& known, std::size_t members,
                      const FitOptions& fit_options, const LearnOptions& options) {
  double sum = 0;
  for (std::size_t k = 0; k < part_template.parts.size(); ++k) {
    const TemplatePart& part = part_template.parts[k];
    const double shapes = static_cast<double>(members) * std::clamp(part.existence, 0.0, 1.0);
    sum += cost_of_means(part.position, known.parts[k].position, shapes);
    sum += cost_of_means(part.scale, known.parts[k].scale, shapes);
    sum += 6 * std::log1p(shapes / std::max(options.prior_shapes_of_spreads, 1e-3));
  }
  return fit_options.alpha * sum;
}

}  // namespace archetype
