// Means and variances with conjugate priors.
#include "core/learning/reestimate.h"

#include <algorithm>
#include <cmath>

#include "core/fitting/deformation.h"
#include "core/fitting/template_surface.h"

namespace archetype {

namespace {

// Values of one quantity over the shapes, with what is known before.
struct Estimate {
  double count = 0;
  Vec3 sum = Vec3::Zero();
  Vec3 square = Vec3::Zero();
  void add(const Vec3& value) {
    count += 1;
    sum += value;
    square += value.cwiseAbs2();
  }
  Vec3 mean(const Gaussian3& prior, double weight) const {
    return (weight * prior.mean + sum) / (weight + count);
  }
  // Summed squared deviations from `about`.
  Vec3 scatter(const Vec3& about) const {
    return (square - 2 * sum.cwiseProduct(about) + count * about.cwiseAbs2()).cwiseMax(0.0);
  }
};

// The estimates of one quantity for all parts, and what was known before. That it was known too coarsely as a
// whole shows long before it shows for each part: the prior variances first get a factor in common.
void set_gaussians(const std::vector<Estimate>& estimates, const std::vector<Gaussian3*>& gaussians,
                   const LearnOptions& options) {
  const double s = options.prior_shapes_of_spreads;
  double count = s;
  double ratio = s;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const Estimate& seen = estimates[k];
    if (seen.count == 0) continue;
    ratio += seen.scatter(seen.sum / seen.count).cwiseQuotient(gaussians[k]->stddev.cwiseAbs2()).sum();
    count += 3 * (seen.count - 1);
  }
  const double factor = std::clamp(ratio / count, options.smallest_spread_factor, 1.0);
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const Estimate& seen = estimates[k];
    Gaussian3& gaussian = *gaussians[k];
    gaussian.mean = seen.mean(gaussian, options.prior_shapes_of_means);
    gaussian.stddev =
        ((s * factor * gaussian.stddev.cwiseAbs2() + seen.scatter(gaussian.mean)) / (s + seen.count))
            .cwiseSqrt()
            .cwiseMax(options.smallest_spread);
  }
}

FeatureGaussian feature_gaussian(std::span<const std::vector<PartObservation>> observed, std::size_t part,
                                 const FeatureGaussian& prior, const LearnOptions& options) {
  // Every shape counts alike, however many samples its part has.
  double shapes = 0;
  Features mean{};
  Features square{};
  for (const auto& shape : observed) {
    const PartObservation& seen = shape[part];
    if (!seen.present || seen.samples == 0) continue;
    shapes += 1;
    for (std::size_t f = 0; f < mean.size(); ++f) {
      mean[f] += seen.feature_sum[f] / static_cast<double>(seen.samples);
      square[f] += seen.feature_square[f] / static_cast<double>(seen.samples);
    }
  }
  const double m = options.prior_shapes_of_means;
  FeatureGaussian result;
  for (std::size_t f = 0; f < mean.size(); ++f) {
    const double prior_square = prior.mean[f] * prior.mean[f] + prior.stddev[f] * prior.stddev[f];
    result.mean[f] = (m * prior.mean[f] + mean[f]) / (m + shapes);
    const double variance = (m * prior_square + square[f]) / (m + shapes) - result.mean[f] * result.mean[f];
    result.stddev[f] = std::max(std::sqrt(std::max(variance, 0.0)), options.smallest_feature_spread);
  }
  return result;
}

}  // namespace

std::vector<PartObservation> observe_parts(const ShapeFit& fit, const ShapeSamples& samples) {
  std::vector<PartObservation> seen(fit.parts.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    seen[k].present = fit.parts[k].present;
    seen[k].box = fit.parts[k].box;
  }
  const auto& features = (fit.yaw_quarters & 1) != 0 ? samples.features_z : samples.features_x;
  for (std::size_t i = 0; i < fit.labels.size(); ++i) {
    if (fit.labels[i] == null_label) continue;
    PartObservation& part = seen[static_cast<std::size_t>(fit.labels[i])];
    ++part.samples;
    for (std::size_t f = 0; f < part.feature_sum.size(); ++f) {
      part.feature_sum[f] += features[i][f];
      part.feature_square[f] += features[i][f] * features[i][f];
    }
  }
  return seen;
}

PartTemplate reestimate(const PartTemplate& initial, std::span<const std::vector<PartObservation>> observed,
                        const LearnOptions& options) {
  PartTemplate result = with_expected_features(initial);
  std::vector<Estimate> positions(result.parts.size());
  std::vector<Estimate> scales(result.parts.size());
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    TemplatePart& part = result.parts[k];
    Estimate& position = positions[k];
    Estimate& scale = scales[k];
    Vec3 turn = Vec3::Zero();
    for (const auto& shape : observed) {
      if (!shape[k].present) continue;
      position.add(shape[k].box.centre);
      scale.add(shape[k].box.half_extent);
      turn += turn_vector(part.orientation.conjugate() * shape[k].box.orientation);
    }
    part.features = feature_gaussian(observed, k, part.features, options);
    const double prior = options.prior_shapes_of_means;
    part.existence = (position.count + prior * std::min(part.existence, 0.99)) /
                     (static_cast<double>(observed.size()) + prior);
    part.orientation = (part.orientation * turn_rotation(turn / (prior + position.count))).normalized();
  }
  std::vector<Gaussian3*> gaussians;
  for (TemplatePart& part : result.parts) gaussians.push_back(&part.position);
  set_gaussians(positions, gaussians, options);
  gaussians.clear();
  for (TemplatePart& part : result.parts) gaussians.push_back(&part.scale);
  set_gaussians(scales, gaussians, options);
  return result;
}

}  // namespace archetype
