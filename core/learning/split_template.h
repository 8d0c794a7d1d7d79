// A second template for some of the shapes of one ("Template spawning" of section 4.2).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/learning/learn_options.h"
#include "core/learning/sightings.h"
#include "core/model/part_template.h"

namespace archetype {

struct LearnedTemplate {
  PartTemplate part_template;
  PartTemplate initial;  // what learning or its division began with: the prior; has the same parts
  // The judging shapes, ascending, whose division was tried last and gained too little; empty where none was
  // tried since the template changed.
  std::vector<std::size_t> undivided = {};
};

// Shapes that take a template, with what its fits to them say.
struct TemplateMembers {
  std::vector<LearningShape> shapes;
  std::vector<Sighting> seen;  // one per shape
  std::size_t judging = 0;     // the first ones decide what is kept
};

struct TemplateSplit {
  LearnedTemplate parent;
  LearnedTemplate child;
  std::vector<bool> to_child;  // one per member
  std::vector<Sighting> seen;  // by the template that each member takes now
  // Of the judging members: by which their choice energies fall more than they would without a division, how
  // many fit better, and how many take the child.
  double gain = 0;
  std::size_t agreeing = 0;
  std::size_t judging_to_child = 0;
};

// What could become a template of its own.
struct SplitProposal {
  std::vector<bool> to_child;  // one per member
  LearnedTemplate child;       // to begin with
};

// For shapes whose parts are arranged alike, for shapes that have a part that others lack, and for shapes
// that the template would have to be stretched to as a whole. Differs from the paper, which clusters the
// learning set by dissimilarities of the fitted shapes: a chair fits a bench badly, and where its parts have
// come to lie on one then tells nothing. A division may be proposed twice, with a child that was stretched
// and with one that was estimated.
std::vector<SplitProposal> split_proposals(const LearnedTemplate& parent, const TemplateMembers& members,
                                           const LearnOptions& options);

// Divides the members between the parent and the child that gains most, some times over: each shape takes
// the template with the least choice energy, and both are estimated anew from those that take them. What was
// learned before is what is known then. Nothing in `split` if no proposal keeps options.smallest_cluster
// shapes on both sides. The child has the parent's name and parts, those that none of its shapes has with a
// small existence. False if cancelled. About 2 x (proposals + 4) fits a member. Differs from the paper, whose
// spawned template is what its cluster says once, and may lose parts: a vase with handles then takes the
// template of those without.
bool split_template(const LearnedTemplate& parent, const TemplateMembers& members,
                    const FitOptions& fit_options, const LearnOptions& options, unsigned threads,
                    const JobControl& control, std::optional<TemplateSplit>& split);

}  // namespace archetype
