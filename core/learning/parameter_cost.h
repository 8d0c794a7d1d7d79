// What the parameters of a template cost.
#pragma once

#include <cstddef>

#include "core/fitting/fit_options.h"
#include "core/learning/learn_options.h"
#include "core/learning/split_proposals.h"

namespace archetype {

// What integrating over six means and six spreads a part leaves of the likelihood of `members` shapes, in
// units of the energies (negative log likelihoods in units of 2 alpha). The mean of n shapes with the spread
// s and known before up to the spread s0 costs log(1 + n s0^2 / s^2) / 2, and its own distance from where it
// was known to be: the narrower a cluster, the more exactly it had to be placed. The spreads cost log((n + m)
// / m) / 2, their prior counting as m shapes. n: the members that have the part. `known`: the prior of the
// parameters; has the same parts. (The Bayesian information criterion, which knows no priors, asks the same
// for wide and for narrow clusters: seats then need more of a kind than they have.)
double parameter_cost(const PartTemplate& part_template, const PartTemplate& known, std::size_t members,
                      const FitOptions& fit_options, const LearnOptions& options);

}  // namespace archetype
