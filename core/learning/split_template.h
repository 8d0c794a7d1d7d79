// Several templates for the shapes of one ("Template spawning" of section 4.2).
#pragma once

#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/learning/learn_options.h"
#include "core/learning/split_proposals.h"

namespace archetype {

struct TemplateSplit {
  std::vector<LearnedTemplate> templates;  // two or three; the first takes the parent's place
  Sides sides;
  std::vector<Sighting> seen;  // by the template that each member takes now
  // By which the choice energies of the judging members fall, less what more parameters cost, more than they
  // would without a division.
  double gain = 0;
};

// Divides the members as that proposal does that gains most beyond what it has to, some times over: each
// shape takes the template with the least choice energy, and all are estimated anew from those that take
// them. (The last time counts. Where the best one does, chairs of one kind are divided further, and their
// labels lose.) What was learned before is what is known then. Nothing in `split` if no proposal gains
// enough, is better for options.divided_share of the judging members, and keeps options.smallest_cluster
// shapes and options.cluster_share of all on each side; enough is more than `least_gain`, and twice that
// where a side has fewer than options.smallest_sure_cluster members. The templates have the parent's name and
// parts, those that none of its shapes has with a small existence. False if cancelled; `split` then tells
// nothing. About 2.4 x (proposals + 16) fits a member, and three more. Differs from the paper, whose spawned
// template is what its cluster says once, and may lose parts: a vase with handles then takes the template of
// those without.
bool split_template(const LearnedTemplate& parent, const TemplateMembers& members,
                    const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
                    const JobControl& control, std::optional<TemplateSplit>& split, double least_gain = 0);

}  // namespace archetype
