// Where the border between two templates should have been drawn.
#pragma once

#include <optional>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/learning/learn_options.h"
#include "core/learning/merge_templates.h"
#include "core/learning/split_template.h"

namespace archetype {

// Divides the members of two templates anew, as if they were the one that `merge` made of them (all of its
// arguments are those of merge_templates()). A division looks for the best border within one template. Shapes
// that an earlier one left on the wrong side (five of nine high chairs with the plain ones) stay there: a
// further division of that template gains too little, and one by one they do not move, since their new
// neighbours have set the means. Not in the paper.
//
// The templates in `split` have the names and what else is known of the two, so that most shapes keep theirs.
// `gain` is by how much the energy falls against what the members take now: the lesser of that with what all
// four cost beside what was known before them, and beside the merged one; `agreeing` is still against the
// merged one. Nothing in `split` if it does not fall, if the two gain nothing over the merged one, if no
// judging member changes sides (to estimate both anew is no new border), if a side would have fewer than
// options.smallest_learning_set judging members or options.smallest_cluster in all, or if a part must exist
// in one template only. False if cancelled. The fits of split_template() with two sides.
bool redivide_templates(const LearnedTemplate& first, const LearnedTemplate& second,
                        const TemplateMembers& members, const Sides& sides, const TemplateMerge& merge,
                        const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
                        const JobControl& control, std::optional<TemplateSplit>& split);

}  // namespace archetype
