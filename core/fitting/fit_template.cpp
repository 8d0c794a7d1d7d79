// The alternation (FitTemplate in figure 2 of the paper).
#include "core/fitting/fit_template.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/fitting/deformation.h"
#include "core/fitting/energy.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"
#include "core/fitting/template_surface.h"

namespace archetype {

namespace {

// What stays the same over yaws and alternations.
class Fitter {
 public:
  Fitter(const PartTemplate& part_template, const ShapeSamples& samples, const FitOptions& options)
      : template_(with_expected_features(part_template)),
        samples_(samples),
        options_(options),
        surface_(sample_template(template_, options.template_points)),
        graph_(make_point_graph(samples, options)),
        unit_(options.distance_unit * samples.radius) {
    if (template_.parts.empty()) throw PreconditionError("a template without parts cannot be fitted");
    if (samples.size() == 0) throw PreconditionError("a shape without samples cannot be fitted");
  }

  // From the mean boxes, the shape turned by `yaw` and moved by `translation`; `labels` may be empty. Nothing
  // if cancelled.
  std::optional<ShapeFit> alternate(int yaw, const Vec3& translation, std::vector<std::int16_t> labels,
                                    const JobControl& control, FitRecording* recording);

 private:
  void label(std::span<const Box> boxes, std::span<const double> features, std::vector<std::int16_t>& labels);
  std::span<const double> features_of(int yaw);

  PartTemplate template_;
  const ShapeSamples& samples_;
  const FitOptions& options_;
  TemplateSurface surface_;
  LabellingGraph graph_;
  double unit_;
  std::array<std::vector<double>, 2> features_;  // for even and odd yaws
  std::vector<Vec3> points_;
  LabelCosts costs_;
  ExpansionWorkspace workspace_;
};

std::span<const double> Fitter::features_of(int yaw) {
  const bool odd = (yaw & 1) != 0;
  std::vector<double>& costs = features_[odd ? 1 : 0];
  if (costs.empty())
    costs = feature_costs(template_, odd ? samples_.features_z : samples_.features_x, options_);
  return costs;
}

// The first step. The expansion knows the null label as the last one; an empty `labels` starts from the
// cheapest.
void Fitter::label(std::span<const Box> boxes, std::span<const double> features,
                   std::vector<std::int16_t>& labels) {
  const std::size_t count = boxes.size() + 1;
  const auto null = static_cast<std::int16_t>(boxes.size());
  label_costs(points_, boxes, features, unit_, options_, costs_);
  if (labels.empty()) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto row = costs_.begin() + static_cast<std::ptrdiff_t>(i * count);
      labels.push_back(
          static_cast<std::int16_t>(std::min_element(row, row + static_cast<std::ptrdiff_t>(count)) - row));
    }
  } else {
    std::replace(labels.begin(), labels.end(), null_label, null);
  }
  expand_labels(graph_, costs_, count, labels, workspace_, options_.expansion);
  std::replace(labels.begin(), labels.end(), null, null_label);
}

std::optional<ShapeFit> Fitter::alternate(int yaw, const Vec3& translation, std::vector<std::int16_t> labels,
                                          const JobControl& control, FitRecording* recording) {
  const std::span<const double> features = features_of(yaw);
  std::vector<Box> boxes;
  for (const TemplatePart& part : template_.parts) boxes.push_back(part.mean_box());
  Vec3 moved = translation;
  Correspondences matches;
  ShapeFit best;
  best.yaw_quarters = yaw;
  best.translation = translation;
  for (const Box& box : boxes) best.parts.push_back({false, box});
  best.labels.assign(samples_.size(), null_label);
  if (recording) recording->steps = {best};
  for (int k = 1; k <= options_.max_alternations; ++k) {
    if (control.cancelled()) return std::nullopt;
    points_.clear();
    for (const Vec3& p : samples_.points) points_.push_back(turn_quarters(p, -yaw) - moved);
    label(boxes, features, labels);
    match(points_, labels, boxes, surface_, matches);
    const MatchedShape shape{points_, labels, &surface_, &matches, unit_};
    const FitEnergy energy = fit_energy(shape, template_, boxes, features, graph_, options_);
    // The labelling cannot see E_t->s (its matches are only defined once all points have labels), so an
    // alternation as a whole may fail to gain. Then the one before was the best, and no later one differs
    // from this.
    if (k > 1 && energy.total() >= best.energy.total()) {
      best.converged = true;
      break;
    }
    const bool same_labels = k > 1 && labels == best.labels;
    best.translation = moved;
    best.labels = labels;
    best.energy = energy;
    best.alternations = k;
    for (std::size_t p = 0; p < boxes.size(); ++p) best.parts[p] = {false, boxes[p]};
    for (const auto l : labels) {
      if (l != null_label) best.parts[static_cast<std::size_t>(l)].present = true;
    }
    if (recording) recording->steps.push_back(best);
    if (same_labels) {
      best.converged = true;
      break;
    }
    const Vec3 step = rigid_step(shape, boxes);
    moved -= step;
    for (Vec3& p : points_) p += step;
    deformation_step(shape, template_, options_, boxes);
  }
  return best;
}

}  // namespace

std::optional<ShapeFit> fit_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                     const FitOptions& options, const JobControl& control,
                                     FitRecording* recording) {
  Fitter fitter(part_template, samples, options);
  std::optional<ShapeFit> best;
  std::array<double, 4> energies;
  energies.fill(std::numeric_limits<double>::infinity());
  for (int yaw = 0; yaw < 4; ++yaw) {
    if (!options.yaws[static_cast<std::size_t>(yaw)]) continue;
    FitRecording steps;
    auto fit = fitter.alternate(yaw, Vec3::Zero(), {}, control, recording ? &steps : nullptr);
    if (!fit) return std::nullopt;
    energies[static_cast<std::size_t>(yaw)] = fit->energy.total();
    if (best && fit->energy.total() >= best->energy.total()) continue;
    best = std::move(fit);
    if (recording) *recording = std::move(steps);
  }
  if (!best) throw PreconditionError("no yaw was given to try");
  best->yaw_energies = energies;
  return best;
}

std::optional<ShapeFit> refit_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                       const ShapeFit& start, const FitOptions& options,
                                       const JobControl& control) {
  Fitter fitter(part_template, samples, options);
  std::vector<std::int16_t> labels = start.labels;
  // Parts may have come or gone since: such labels start over.
  const auto parts = static_cast<std::int16_t>(part_template.parts.size());
  const bool usable = labels.size() == samples.size() &&
                      std::all_of(labels.begin(), labels.end(), [parts](auto l) { return l < parts; });
  if (!usable) labels.clear();
  auto fit = fitter.alternate(start.yaw_quarters, start.translation, std::move(labels), control, nullptr);
  if (fit) {
    fit->yaw_energies.fill(std::numeric_limits<double>::infinity());
    fit->yaw_energies[static_cast<std::size_t>(start.yaw_quarters)] = fit->energy.total();
  }
  return fit;
}

}  // namespace archetype
