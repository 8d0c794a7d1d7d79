// Labelling, correspondences, the rigid and the deformation step, and the parts that are left out.
#include "core/fitting/alternation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/fitting/choose_solids.h"
#include "core/fitting/deformation.h"
#include "core/fitting/energy.h"
#include "core/fitting/evidence.h"
#include "core/fitting/expected_template.h"
#include "core/fitting/label_costs.h"
#include "core/fitting/point_graph.h"

namespace archetype {

namespace {

// Differs from the paper: alternations also end when they gain less than this share of the energy. Without it
// single points at boundaries flip for dozens of alternations; energies end within 0.1 % of those without, in
// half the time.
constexpr double smallest_gain = 1e-4;

constexpr double exceptional_existence = 0.1;

// No sample takes the label of a part that was dropped: dearer than all other costs together.
constexpr std::int32_t forbidden_cost = 1 << 30;

}  // namespace

bool is_exceptional(const TemplatePart& part) {
  return !part.must_exist && part.existence < exceptional_existence;
}

Fitter::Fitter(const PartTemplate& part_template, const ShapeSamples& samples, const FitOptions& options,
               std::span<const PinnedLabel> pinned)
    : Fitter(part_template, samples, make_point_graph(samples, options), options, pinned) {}

Fitter::Fitter(const PartTemplate& part_template, const ShapeSamples& samples, LabellingGraph graph,
               const FitOptions& options, std::span<const PinnedLabel> pinned)
    : template_(expected_template(part_template)),
      samples_(samples),
      options_(options),
      pinned_(pinned),
      tree_(samples.points),
      surface_(sample_template(template_, options.template_points)),
      graph_(std::move(graph)),
      unit_(options.distance_unit * samples.radius) {
  if (template_.parts.empty()) throw PreconditionError("a template without parts cannot be fitted");
  if (samples.size() == 0) throw PreconditionError("a shape without samples cannot be fitted");
  for (const PinnedLabel& pin : pinned) {
    if (pin.sample >= samples.size() || pin.label >= static_cast<std::int16_t>(template_.parts.size()))
      throw PreconditionError("a sample is pinned that is not there, or to a part that is not");
  }
}

std::span<const double> Fitter::features_of(int yaw) {
  const bool odd = (yaw & 1) != 0;
  std::vector<double>& costs = features_[odd ? 1 : 0];
  if (costs.empty())
    costs = feature_costs(template_, odd ? samples_.features_z : samples_.features_x, options_);
  return costs;
}

// The first step. The expansion knows the null label as the last one. Samples without a label that they may
// have start from the cheapest.
void Fitter::label(const Alternation& run, std::span<const double> features,
                   std::vector<std::int16_t>& labels) {
  const std::size_t parts = run.boxes.size();
  const std::size_t count = parts + 1;
  const auto null = static_cast<std::int16_t>(parts);
  label_costs(points_, run.boxes, features, unit_, options_, costs_);
  for (std::size_t k = 0; k < parts; ++k) {
    for (std::size_t i = 0; run.dropped[k] && i < points_.size(); ++i) costs_[i * count + k] = forbidden_cost;
  }
  const bool unlabelled = labels.empty();
  labels.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!unlabelled && labels[i] == null_label) {
      labels[i] = null;
    } else if (unlabelled || run.dropped[static_cast<std::size_t>(labels[i])]) {
      const auto row = costs_.begin() + static_cast<std::ptrdiff_t>(i * count);
      labels[i] =
          static_cast<std::int16_t>(std::min_element(row, row + static_cast<std::ptrdiff_t>(count)) - row);
    }
  }
  hold_pinned(parts, labels);
  expand_labels(graph_, costs_, count, labels, workspace_, options_.expansion);
  std::replace(labels.begin(), labels.end(), null, null_label);
}

// What a sample is pinned to costs it nothing, and all else is forbidden.
void Fitter::hold_pinned(std::size_t null, std::vector<std::int16_t>& labels) {
  for (const PinnedLabel& pin : pinned_) {
    const std::size_t label = pin.label == null_label ? null : static_cast<std::size_t>(pin.label);
    const auto row = std::span(costs_).subspan(pin.sample * (null + 1), null + 1);
    std::ranges::fill(row, forbidden_cost);
    row[label] = 0;
    labels[pin.sample] = static_cast<std::int16_t>(label);
  }
}

Alternation Fitter::start(int yaw, const Vec3& translation, std::vector<Box> boxes,
                          std::vector<std::int16_t> labels) const {
  Alternation run;
  for (const Box& box : boxes) run.fit.parts.push_back({false, box});
  run.boxes = std::move(boxes);
  run.fit.yaw_quarters = yaw;
  run.fit.translation = run.translation = translation;
  run.fit.labels.assign(samples_.size(), null_label);
  run.labels = std::move(labels);
  run.dropped.assign(template_.parts.size(), false);
  return run;
}

std::vector<Alternation> Fitter::start_all() const {
  std::vector<Alternation> runs;
  std::vector<Vec3> turned(samples_.size());
  for (int yaw = 0; yaw < 4; ++yaw) {
    if (std::isinf(options_.yaw_costs[static_cast<std::size_t>(yaw)])) continue;
    for (std::size_t i = 0; i < turned.size(); ++i) turned[i] = turn_quarters(samples_.points[i], -yaw);
    runs.push_back(start(yaw, Vec3::Zero(), mean_boxes(template_), {}));
    runs.push_back(start(yaw, Vec3::Zero(), stretched_boxes(template_, turned), {}));
    runs.back().stretched = true;
  }
  return runs;
}

void Fitter::place(const Alternation& run) {
  points_.clear();
  for (const Vec3& p : samples_.points)
    points_.push_back(turn_quarters(p, -run.fit.yaw_quarters) - run.translation);
}

void Fitter::advance(Alternation& run) {
  const int yaw = run.fit.yaw_quarters;
  const std::span<const double> features = features_of(yaw);
  place(run);
  label(run, features, run.labels);
  match_placed(run, run.boxes, run.matches);
  const MatchedShape shape{points_, run.labels, &surface_, &run.matches, unit_};
  const FitEnergy energy = fit_energy(shape, template_, run.boxes, features, graph_, options_);
  // The labelling cannot see E_t->s (its matches are only defined once all points have labels), so an
  // alternation as a whole may fail to gain. Then the one before was the best, and no later one differs from
  // this.
  const bool first = std::exchange(run.fresh, false);
  run.gain = first ? 1 : 1 - energy.total() / run.fit.energy.total();
  if (run.gain <= 0) {
    run.fit.converged = run.ended = true;
    return;
  }
  const bool same_labels = !first && run.labels == run.fit.labels;
  run.fit.translation = run.translation;
  run.fit.labels = run.labels;
  run.fit.energy = energy;
  ++run.fit.alternations;
  for (std::size_t p = 0; p < run.boxes.size(); ++p)
    run.fit.parts[p] = {false, template_.parts[p].mean_box()};
  for (const auto l : run.labels) {
    if (l == null_label) continue;
    const auto part = static_cast<std::size_t>(l);
    run.fit.parts[part] = {true, run.boxes[part]};
  }
  run.fit.converged = same_labels || run.gain < smallest_gain;
  run.ended = run.fit.converged || run.fit.alternations >= options_.max_alternations;
  if (run.ended) return;
  const Vec3 step = rigid_step(shape, run.boxes);
  run.translation -= step;
  for (Vec3& p : points_) p += step;
  deformation_step(shape, template_, options_, run.boxes);
}

Alternation Fitter::without(const Alternation& run, std::size_t part) const {
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < run.fit.parts.size(); ++k) {
    boxes.push_back(k == part ? template_.parts[k].mean_box() : run.fit.parts[k].box);
  }
  Alternation next = start(run.fit.yaw_quarters, run.fit.translation, std::move(boxes), run.fit.labels);
  next.fit.alternations = run.fit.alternations;
  next.dropped = run.dropped;
  next.dropped[part] = true;
  next.stretched = run.stretched;
  next.steps = run.steps;
  next.matches = run.matches;
  return next;
}

Alternation Fitter::as_fitted(const Alternation& run) {
  std::vector<Box> boxes;
  for (const FittedPart& fitted : run.fit.parts) boxes.push_back(fitted.box);
  Alternation at = start(run.fit.yaw_quarters, run.fit.translation, std::move(boxes), run.fit.labels);
  at.matches = run.matches;
  place(at);
  match_placed(at, at.boxes, at.matches);
  return at;
}

bool Fitter::take_round_solids(Alternation& run) {
  const Alternation at = as_fitted(run);
  const MatchedShape shape{points_, at.labels, &surface_, &at.matches, unit_};
  const auto match_boxes = [&](std::span<const Box> boxes, Correspondences& matches) {
    match_placed(at, boxes, matches);
  };
  auto boxes = choose_solids(shape, template_, at.boxes, options_, match_boxes);
  if (!boxes) return false;
  run.boxes = std::move(*boxes);
  run.labels = at.labels;
  run.translation = at.translation;
  run.ended = false;
  return true;
}

double Fitter::energy_without_exceptions(const Alternation& run) const {
  double energy = run.fit.energy.total();
  for (std::size_t k = 0; k < run.fit.parts.size(); ++k) {
    const TemplatePart& part = template_.parts[k];
    if (is_exceptional(part) && run.fit.parts[k].present)
      energy -= existence_energy(part, true, options_) - existence_energy(part, false, options_);
  }
  return energy;
}

std::optional<std::size_t> Fitter::unfounded_part(const Alternation& run, bool only_exceptions) {
  const Alternation at = as_fitted(run);
  label_costs(points_, at.boxes, features_of(at.fit.yaw_quarters), unit_, options_, costs_);
  std::vector<double> evidence = part_evidence({points_, at.labels, &surface_, &at.matches, unit_}, template_,
                                               at.boxes, costs_, options_);
  for (const PinnedLabel& pin : pinned_) {
    if (pin.label != null_label)
      evidence[static_cast<std::size_t>(pin.label)] = std::numeric_limits<double>::infinity();
  }
  for (std::size_t k = 0; only_exceptions && k < evidence.size(); ++k)
    if (!is_exceptional(template_.parts[k])) evidence[k] = std::numeric_limits<double>::infinity();
  const auto least = std::min_element(evidence.begin(), evidence.end());
  if (*least >= 0) return std::nullopt;
  return static_cast<std::size_t>(least - evidence.begin());
}

}  // namespace archetype
