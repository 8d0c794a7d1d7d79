// One round of section 4.2: fit, learn, spawn, and keep what is better.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/learning/learn_options.h"
#include "core/learning/split_template.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"

namespace archetype {

// What became of one template in a round.
struct TemplateOrigin {
  std::size_t parent = 0;  // its index before the round
  bool changed = false;    // re-estimated or spawned
};

struct LearningRound {
  std::vector<LearnedTemplate> templates;
  std::vector<TemplateOrigin> origins;  // one per template
  bool dropped = false;                 // a template that no judging shape takes was left out
  double energy_before = 0;  // mean choice energy over the judging shapes, with what the templates cost
  double energy = 0;         // afterwards
  double misfit = 0;         // mean E_data of the judging shapes' fits, afterwards
  double parts = 0;          // mean number of parts that these have
  std::vector<std::size_t>
      taken;              // by judging shape, afterwards: the index of the template that fits it best
  std::vector<int> yaws;  // by judging shape: the known ones, or those that were agreed on in this round

  bool changed() const;
};

// Fits `templates` to all shapes, re-estimates each from its learning set, those that have the same parts
// together from all of their shapes but outliers (estimate_siblings.h), and divides those that stay as they
// are where that gains (split_template.h). `judging` decides what is kept: a re-estimated template if the
// share options.agreeing_share of the shapes that take it fit better, several together if their energy falls,
// a division if the share options.divided_share fits better and if it lowers the energy by more than its
// parameters cost. Where nothing else changes, two become one if that lowers the energy, in which each
// template costs what a division has to gain (merge_templates.h). `others` are only learned from. The yaws of
// the judging shapes are decided together (agreed_yaws.h). Templates that no judging shape takes are dropped,
// except those that shapes are pinned to. Nothing if cancelled. Throws PreconditionError without templates,
// NumericError where a shape has no finite energy with any. Progress counts the fits of the round, with those
// ahead as far as it can be told. Deterministic whatever the number of threads; about 2 fits per template and
// judging shape and one per other shape, one more per judging shape for a template without siblings, 2 to 8
// more per template and shape for those that have some, and those of the divisions, some 90 and 5 for each
// part per shape. Differs from the paper, which keeps every round's templates: so learning can leave a
// collection worse.
//
// corrections: what was corrected by hand, one per shape with the judging ones first, null where nothing was;
// or none at all. Pinned yaws, templates and labels hold in all fits, and pinned yaws count when yaws are
// decided; shapes pinned to a template stay with it when it is divided. Shapes marked to be learned from are
// in the learning set of their template whatever their energy. Those marked as outliers are for the caller to
// leave out.
//
// known_yaws: quarter turns of the judging shapes (LearningRound::yaws of the first round), or none at all.
// They are held against others (add_cost_of_turning()). Differs from the paper: where a template of teapots
// has a handle on one side and a spout on the other, the turned one does about as well, and whole clusters
// would change what their parts mean.
std::optional<LearningRound> learning_round(std::span<const LearnedTemplate> templates,
                                            std::span<const ShapeSamples> judging,
                                            std::span<const ShapeSamples> others,
                                            const FitOptions& fit_options, const LearnOptions& options,
                                            unsigned threads, const JobControl& control,
                                            std::span<const ShapeCorrection* const> corrections = {},
                                            std::span<const int> known_yaws = {});

}  // namespace archetype
