// New parameters of all templates of a family at once.
#pragma once

#include <span>
#include <vector>

#include "core/learning/learn_options.h"
#include "core/learning/reestimate.h"
#include "core/learning/split_proposals.h"

namespace archetype {

// Whether two have the same parts: their names and labels, in the same order.
bool are_siblings(const PartTemplate& a, const PartTemplate& b);

// The templates `siblings`, one or more that all have the same parts, each with means and spreads of its own
// shapes (`observed`: by template, one for each, by shape, by part). What is known of its spreads beforehand
// is what the shapes of all siblings say together, each about the mean of its own template; of that in turn,
// what was known is the widest initial spread of any of them. A template with fewer than
// options.smallest_learning_set shapes stays as it is, and says nothing for the others. Differs from the
// paper, which estimates each alone: with seven to nine shapes the prior says most of what a template
// expects, that of a second division knows the narrow spreads of its parent and that of a first one the wide
// ones of the collection, and the narrow one draws shapes of other kinds to it, the more so the more it has.
//
// What was known then is what the results have as their initial templates: means of their own, as after a
// division (split_proposals.h), and the common spreads. (Were these as wide as before, a division would seem
// to gain what is gained by knowing them better: of figure 1's 36 chairs, seed 5, six templates come then.)
std::vector<LearnedTemplate> estimate_siblings(
    std::span<const LearnedTemplate> siblings,
    std::span<const std::vector<std::vector<PartObservation>>> observed, const LearnOptions& options);

}  // namespace archetype
