// The alternation (FitTemplate in figure 2 of the paper).
#include "core/fitting/fit_template.h"

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
#include "core/fitting/starting_boxes.h"
#include "core/fitting/template_surface.h"

namespace archetype {

namespace {

// Differs from the paper: alternations also end when they gain less than this share of the energy. Without it
// single points at boundaries flip for dozens of alternations; energies end within 0.1 % of those without, in
// half the time.
constexpr double smallest_gain = 1e-4;

// Every yaw is started twice: from the mean boxes, and from the mean boxes stretched to the bounds of the
// shape, which reaches a bench from a chair. Every start takes this many alternations before the best of them
// is followed to its end; each other one goes on only as long as that many more of its last gain could still
// make it the best. (With one start a yaw, one of 320 fits ended above the energy of the yaws done in full.)
constexpr int first_alternations = 2;
constexpr double more_gains = 25;

// Parts that fewer shapes have than this say nothing of the yaw, unless the shape gives evidence for them:
// the arms that a cluster of chairs without any had to begin with find samples in the right yaw only, and
// would cost it more than a wrong one loses. So they are left out before yaws are compared, in all starts
// that come within_reach of the best. (With all parts without evidence left out vases lose 1.6 %.)
constexpr double rare_existence = 0.1;
constexpr double within_reach = 1.5;

bool is_rare(const TemplatePart& part) {
  return !part.must_exist && part.existence < rare_existence;
}

// No sample takes the label of a part that was dropped: dearer than all other costs together.
constexpr std::int32_t forbidden_cost = 1 << 30;

// One yaw on its way.
struct Alternation {
  ShapeFit fit;  // the state after the last alternation
  std::vector<Box> boxes;
  std::vector<std::int16_t> labels;
  Vec3 translation;
  Correspondences matches;
  std::vector<bool> dropped;  // parts that no sample may be mapped to
  double gain = 1;            // of the last alternation, as a share of the energy
  bool fresh = true;          // not advanced yet since it started or lost a part
  bool ended = false;
  bool stretched = false;       // at the start
  std::vector<ShapeFit> steps;  // if they are wanted: the start and after each alternation
};

// What stays the same over yaws and alternations.
class Fitter {
 public:
  Fitter(const PartTemplate& part_template, const ShapeSamples& samples, const FitOptions& options,
         std::span<const PinnedLabel> pinned)
      : Fitter(part_template, samples, make_point_graph(samples, options), options, pinned) {}
  Fitter(const PartTemplate& part_template, const ShapeSamples& samples, LabellingGraph graph,
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

  // The shape turned by `yaw` and moved by `translation`; `labels` may be empty.
  Alternation start(int yaw, const Vec3& translation, std::vector<Box> boxes,
                    std::vector<std::int16_t> labels) const;
  std::vector<Alternation> start_all() const;
  // One alternation; sets `ended` when there is nothing more to gain.
  void advance(Alternation& run);
  // Goes on with round solids in the boxes of a run that has ended, where they are clearly better.
  bool take_round_solids(Alternation& run);
  // The present part with the least evidence, if it is better left out; of all parts, or of the rare ones.
  std::optional<std::size_t> unfounded_part(const Alternation& run, bool only_rare = false);
  // As if its rare parts were not there, as far as existence goes.
  double energy_without_rare(const Alternation& run) const;
  // All parts once more, from where those that the run has found would put them, without labels.
  Alternation carried(const Alternation& run) const {
    return start(run.fit.yaw_quarters, run.fit.translation, carried_boxes(template_, run.fit.parts), {});
  }
  // The same state with one part less, its box back at the mean, to be advanced anew.
  Alternation without(const Alternation& run, std::size_t part) const;

 private:
  // The state that the run's fit is of, matched.
  Alternation as_fitted(const Alternation& run);
  void place(const Alternation& run);
  void match_placed(const Alternation& run, std::span<const Box> boxes, Correspondences& matches) const {
    match({&tree_, points_, run.fit.yaw_quarters, run.translation}, run.labels, boxes, surface_, matches);
  }
  void label(const Alternation& run, std::span<const double> features, std::vector<std::int16_t>& labels);
  void hold_pinned(std::size_t null, std::vector<std::int16_t>& labels);
  std::span<const double> features_of(int yaw);

  PartTemplate template_;
  const ShapeSamples& samples_;
  const FitOptions& options_;
  std::span<const PinnedLabel> pinned_;
  KdTree tree_;
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

double Fitter::energy_without_rare(const Alternation& run) const {
  double energy = run.fit.energy.total();
  for (std::size_t k = 0; k < run.fit.parts.size(); ++k) {
    const TemplatePart& part = template_.parts[k];
    if (is_rare(part) && run.fit.parts[k].present)
      energy -= existence_energy(part, true, options_) - existence_energy(part, false, options_);
  }
  return energy;
}

std::optional<std::size_t> Fitter::unfounded_part(const Alternation& run, bool only_rare) {
  const Alternation at = as_fitted(run);
  label_costs(points_, at.boxes, features_of(at.fit.yaw_quarters), unit_, options_, costs_);
  std::vector<double> evidence = part_evidence({points_, at.labels, &surface_, &at.matches, unit_}, template_,
                                               at.boxes, costs_, options_);
  for (const PinnedLabel& pin : pinned_) {
    if (pin.label != null_label)
      evidence[static_cast<std::size_t>(pin.label)] = std::numeric_limits<double>::infinity();
  }
  for (std::size_t k = 0; only_rare && k < evidence.size(); ++k)
    if (!is_rare(template_.parts[k])) evidence[k] = std::numeric_limits<double>::infinity();
  const auto least = std::min_element(evidence.begin(), evidence.end());
  if (*least >= 0) return std::nullopt;
  return static_cast<std::size_t>(least - evidence.begin());
}

// Advances a run until it ends, and then without the rare parts that the shape gives no evidence for. False
// when cancelled.
template <typename Advance>
bool leave_out_rare(Fitter& fitter, Alternation& run, const JobControl& control, const Advance& advance) {
  for (;;) {
    while (!run.ended && !control.cancelled()) advance(run);
    if (control.cancelled()) return false;
    const std::optional<std::size_t> part = fitter.unfounded_part(run, true);
    if (!part) return true;
    run = fitter.without(run, *part);
  }
}

// Advances a run until it ends, goes on with what is round, and then without the parts that the shape gives
// no evidence for, one after the other. False when cancelled.
template <typename Advance>
bool run_to_end(Fitter& fitter, Alternation& run, const FitOptions& options, const JobControl& control,
                const Advance& advance) {
  for (bool all_boxes = true;; all_boxes = false) {
    while (!run.ended && !control.cancelled()) advance(run);
    if (control.cancelled()) return false;
    if (all_boxes && fitter.take_round_solids(run)) continue;
    if (!options.drop_parts) return true;
    const std::optional<std::size_t> part = fitter.unfounded_part(run);
    if (!part) return true;
    run = fitter.without(run, *part);
  }
}

}  // namespace

std::optional<ShapeFit> fit_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                     const FitOptions& options, const JobControl& control,
                                     FitRecording* recording, std::span<const PinnedLabel> pinned) {
  Fitter fitter(part_template, samples, options, pinned);
  std::vector<Alternation> runs = fitter.start_all();
  const auto advance = [&](Alternation& run) {
    if (recording && run.steps.empty()) run.steps.push_back(run.fit);
    fitter.advance(run);
    // An alternation that gained nothing leaves the fit as it was.
    if (recording && static_cast<int>(run.steps.size()) <= run.fit.alternations) run.steps.push_back(run.fit);
  };
  if (runs.empty()) throw PreconditionError("no yaw was given to try");
  for (Alternation& run : runs) {
    for (int i = 0; i < first_alternations && !run.ended && !control.cancelled(); ++i) advance(run);
  }
  const bool has_rare = options.drop_parts && std::ranges::any_of(part_template.parts, is_rare);
  const auto energy = [&](const Alternation& run) {
    return has_rare ? fitter.energy_without_rare(run) : run.fit.energy.total();
  };
  const auto yaw_of = [](const Alternation& run) { return static_cast<std::size_t>(run.fit.yaw_quarters); };
  const auto cost = [&](const Alternation& run) { return energy(run) + options.yaw_costs[yaw_of(run)]; };
  std::ranges::stable_sort(runs, {}, cost);
  double least = std::numeric_limits<double>::infinity();
  for (Alternation& run : runs) {
    while (!run.ended && cost(run) - run.fit.energy.total() * more_gains * run.gain < least) {
      if (control.cancelled()) return std::nullopt;
      advance(run);
    }
    least = std::min(least, cost(run));
  }
  std::array<double, 4> energies;
  energies.fill(std::numeric_limits<double>::infinity());
  for (Alternation& run : runs) {
    const bool in_reach = cost(run) <= within_reach * least;
    if (has_rare && in_reach && !leave_out_rare(fitter, run, control, advance)) return std::nullopt;
    energies[yaw_of(run)] = std::min(energies[yaw_of(run)], energy(run));
  }
  // The yaw with the least cost; of its two starts, the stretched one only if it is clearly better.
  std::size_t yaw = 0;
  for (std::size_t other = 1; other < energies.size(); ++other) {
    if (energies[other] + options.yaw_costs[other] < energies[yaw] + options.yaw_costs[yaw]) yaw = other;
  }
  const auto comparable = [&](const Alternation& run) {
    return energy(run) * (run.stretched ? stretch_handicap : 1);
  };
  Alternation* best = nullptr;
  for (Alternation& run : runs) {
    if (yaw_of(run) != yaw) continue;
    while (!run.ended && !control.cancelled()) advance(run);
    if (has_rare && !leave_out_rare(fitter, run, control, advance)) return std::nullopt;
    if (!best || comparable(run) < comparable(*best)) best = &run;
  }
  if (!run_to_end(fitter, *best, options, control, advance)) return std::nullopt;
  // Differs from the paper: once more, with all parts, from the boxes that this carries. A part whose mean
  // box lay far off was left out before it could move to where the shape has it. (Vases, own labels by area
  // of five samplings: 84.2 -> 85.4 %; three times gains nothing further, and before the yaw is chosen it
  // loses.)
  Alternation again = fitter.carried(*best);
  if (!run_to_end(fitter, again, options, control, advance)) return std::nullopt;
  if (again.fit.energy.total() < best->fit.energy.total()) *best = std::move(again);
  if (recording) recording->steps = std::move(best->steps);
  ShapeFit fit = best->fit;
  fit.yaw_energies = energies;
  return fit;
}

namespace {

// Where a fit of nearly the same template goes on from.
struct NearStart {
  const PartTemplate& part_template;
  const ShapeFit& start;
  std::vector<std::int16_t> labels;  // empty: they start over, parts may have come or gone since
  bool same_parts = false;

  NearStart(const PartTemplate& of, const ShapeSamples& samples, const ShapeFit& near)
      : part_template(of), start(near), labels(near.labels) {
    const auto parts = static_cast<std::int16_t>(of.parts.size());
    const bool usable = labels.size() == samples.size() &&
                        std::all_of(labels.begin(), labels.end(), [parts](auto l) { return l < parts; });
    if (!usable) labels.clear();
    same_parts = usable && near.parts.size() == of.parts.size();
  }
  Alternation from_means(const Fitter& fitter) const {
    return fitter.start(start.yaw_quarters, start.translation, mean_boxes(part_template), labels);
  }
  // The mean boxes may not reach what the fit before has reached.
  Alternation from_fitted(const Fitter& fitter) const {
    std::vector<Box> boxes;
    for (const FittedPart& part : start.parts) boxes.push_back(part.box);
    return fitter.start(start.yaw_quarters, start.translation, std::move(boxes), labels);
  }
};

ShapeFit of_one_yaw(const Alternation& run) {
  ShapeFit fit = run.fit;
  fit.yaw_energies.fill(std::numeric_limits<double>::infinity());
  fit.yaw_energies[static_cast<std::size_t>(fit.yaw_quarters)] = fit.energy.total();
  return fit;
}

}  // namespace

std::optional<ShapeFit> refit_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                       const ShapeFit& start, const FitOptions& options,
                                       const JobControl& control, std::span<const PinnedLabel> pinned) {
  Fitter fitter(part_template, samples, options, pinned);
  const NearStart near(part_template, samples, start);
  const auto advance = [&](Alternation& state) { fitter.advance(state); };
  Alternation run = near.from_means(fitter);
  if (!run_to_end(fitter, run, options, control, advance)) return std::nullopt;
  if (near.same_parts) {
    Alternation other = near.from_fitted(fitter);
    if (!run_to_end(fitter, other, options, control, advance)) return std::nullopt;
    if (other.fit.energy.total() < run.fit.energy.total()) run = std::move(other);
  }
  return of_one_yaw(run);
}

std::optional<ShapeFit> follow_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                        const LabellingGraph& graph, const ShapeFit& start,
                                        const FitOptions& options, const JobControl& control,
                                        std::span<const PinnedLabel> pinned) {
  Fitter fitter(part_template, samples, graph, options, pinned);
  const NearStart near(part_template, samples, start);
  const auto settle = [&](Alternation& state) {
    while (!state.ended && !control.cancelled()) fitter.advance(state);
  };
  Alternation run = near.from_means(fitter);
  if (near.same_parts) {
    for (std::size_t i = 0; i < run.boxes.size(); ++i) run.boxes[i].solid = start.parts[i].box.solid;
    Alternation other = near.from_fitted(fitter);
    for (Alternation* state : {&run, &other})
      for (int i = 0; i < first_alternations && !state->ended; ++i) fitter.advance(*state);
    if (other.fit.energy.total() < run.fit.energy.total()) run = std::move(other);
  }
  settle(run);
  const auto unfounded = [&] { return options.drop_parts ? fitter.unfounded_part(run) : std::nullopt; };
  for (auto part = unfounded(); part && !control.cancelled(); part = unfounded()) {
    run = fitter.without(run, *part);
    settle(run);
  }
  if (control.cancelled()) return std::nullopt;
  return of_one_yaw(run);
}

}  // namespace archetype
