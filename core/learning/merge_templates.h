// One template for the shapes of two.
#pragma once

#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/learning/learn_options.h"
#include "core/learning/split_proposals.h"

namespace archetype {

struct TemplateMerge {
  PartTemplate part_template;
  std::vector<Sighting> seen;  // by it, one per member
  double gain = 0;  // by which the choice energies of the judging members and the cost of parameters fall
};

// Estimates the first of two templates anew from the members of both, twice over. Divisions are found one
// after the other, and one that cuts a kind in two (table lamps to the floor lamps, and others to the desk
// lamps) leaves pieces that later divisions set free; only together are they a cluster. Not in the paper.
// sides: by member, 0 if it takes the first template and 1 if the second. Nothing in `merge` if their parts
// are not the same or if one has no judging member. What is known before is what was
// known of the first, after an estimate with its siblings where that one was: so two are joined less easily
// than they might be, and not alike in either order. False if cancelled. Two fits a member.
bool merge_templates(const LearnedTemplate& first, const LearnedTemplate& second,
                     const TemplateMembers& members, const Sides& sides, const FitOptions& fit_options,
                     const LearnOptions& options, unsigned threads, const JobControl& control,
                     std::optional<TemplateMerge>& merge);

}  // namespace archetype
