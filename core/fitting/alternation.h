// The steps of fit_template(): one yaw on its way, and what stays the same over yaws and alternations.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/fitting/alpha_expansion.h"
#include "core/fitting/correspondence.h"
#include "core/fitting/fit_options.h"
#include "core/fitting/pinned_labels.h"
#include "core/fitting/starting_boxes.h"
#include "core/fitting/template_surface.h"
#include "core/geometry/kd_tree.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// So few shapes have the part that it should not tell how one stands; never if it must exist.
bool is_exceptional(const TemplatePart& part);

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

// What stays the same over yaws and alternations: one template on its way to one shape. The constructors
// throw PreconditionError without parts or samples, or if a sample is pinned that is not there, or to no
// part. graph: make_point_graph(samples, options). Refers to the samples, the options and the pinned labels.
class Fitter {
 public:
  Fitter(const PartTemplate& part_template, const ShapeSamples& samples, const FitOptions& options,
         std::span<const PinnedLabel> pinned);
  Fitter(const PartTemplate& part_template, const ShapeSamples& samples, LabellingGraph graph,
         const FitOptions& options, std::span<const PinnedLabel> pinned);

  // The shape turned by `yaw` and moved by `translation`; `labels` may be empty.
  Alternation start(int yaw, const Vec3& translation, std::vector<Box> boxes,
                    std::vector<std::int16_t> labels) const;
  std::vector<Alternation> start_all() const;
  // One alternation; sets `ended` when there is nothing more to gain.
  void advance(Alternation& run);
  // Goes on with round solids in the boxes of a run that has ended, where they are clearly better.
  bool take_round_solids(Alternation& run);
  // The present part with the least evidence, if it is better left out; of all parts, or of the exceptional
  // ones.
  std::optional<std::size_t> unfounded_part(const Alternation& run, bool only_exceptions = false);
  // As if its exceptional parts were not there, as far as existence goes.
  double energy_without_exceptions(const Alternation& run) const;
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

}  // namespace archetype
