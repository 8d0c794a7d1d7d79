// Which of several templates a shape takes.
#pragma once

#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// What templates are compared by, for a fit to `samples`: its energy with two changes. Comparable between
// templates and options of one kind; may be below zero.
//
// The spreads of the template cost something: the logarithms of the standard deviations that make Gaussians
// of equations 5 and 6 densities. Without them a template that expects nothing in particular would fit every
// shape best.
//
// Differs from the paper, which compares equations 3 and 4 as the fit has them. In E_t->s a part counts by
// the area of its fitted box, not of its mean box, and absent parts do not count. A lamp's shade is open: the
// ends of its box are far from all samples, whatever the template. A template whose mean shade is small had
// fewer points on these ends and cost less, so lamps with large shades took it. And the distances of a round
// part are divided by options.round_share: as it has to lower them to that share (choose_solids.h), a fit
// where it just does would otherwise cost a fifth less than one where it just does not. (Figure 9 of the
// paper, 20 generated lamps of three kinds: 13 right in two clusters without either, 20 in three with both;
// another seed 16 and 18.)
//
// Takes a search of the nearest sample for each point of the template and of the closest point for each
// sample, as an alternation does: some hundredths of a fit.
double choice_energy(const ShapeFit& fit, const PartTemplate& part_template, const ShapeSamples& samples,
                     const FitOptions& options);

}  // namespace archetype
