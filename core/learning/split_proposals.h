// Where a template might be divided ("Template spawning" of section 4.2).
#pragma once

#include <cstddef>
#include <vector>

#include "core/learning/learn_options.h"
#include "core/learning/sightings.h"
#include "core/model/part_template.h"

namespace archetype {

struct LearnedTemplate {
  PartTemplate part_template;
  // The prior, which has the same parts: what learning began with, its division, or its last estimate with
  // its siblings.
  PartTemplate initial;
  // The judging shapes, ascending, whose division was tried last and gained too little, or that were merged;
  // empty where neither was done since the template changed.
  std::vector<std::size_t> undivided = {};
  bool pinned = false;  // some shape is pinned to it, judging or not: it stays, with its name
};

// Shapes that take a template, with what its fits to them say.
struct TemplateMembers {
  std::vector<LearningShape> shapes;
  std::vector<Sighting> seen;  // one per shape
  std::size_t judging = 0;     // the first ones decide what is kept
};

using Sides = std::vector<std::size_t>;  // by member: the template of a division that it takes

// What could become two or three templates.
struct SplitProposal {
  Sides sides;
  std::vector<LearnedTemplate> templates;  // to begin with; the first takes its parent's place
  bool at_even_odds = false;               // made from, and to be divided with, the members as seen so
};

// For shapes whose parts are arranged alike, for shapes that have a part that others lack, for shapes that
// the template would have to be stretched to as a whole, and for those whose samples lie alike about the
// vertical axis. Differs from the paper, which clusters the learning set by dissimilarities of the fitted
// shapes: a chair fits a bench badly, and where its parts have come to lie on one then tells nothing. A
// division may be proposed twice, with a child that was stretched and with one that was estimated. All are
// drawn to where their clusters were found in later estimates, up to the first with their siblings
// (estimate_siblings.h). Where the members have a part or lack it otherwise when what was known of its
// existence is no evidence (`at_even_odds`, the same members in the same order), those that have it and those
// that lack it are proposed once more from these: arms that were taken to be nearly certain are seen on plain
// chairs. Some 20 of them, and up to two a part more.
std::vector<SplitProposal> split_proposals(const LearnedTemplate& parent, const TemplateMembers& members,
                                           const TemplateMembers& at_even_odds, const LearnOptions& options);

}  // namespace archetype
