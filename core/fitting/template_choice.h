// Which of several templates a shape takes.
#pragma once

#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// The energy of the fit with what its template's spreads cost: without that a template that expects nothing
// in particular would fit every shape best. The Gaussians of equation 5 bring the logarithms of their
// standard deviations. Those of equation 6 belong to boxes, which are chosen and not known: what counts is
// the integral over all of them. For spreads s and data that tell a box's sides with a precision W, it is
// alpha log(1 + W s^2) beside the energy of the best box: log s^2 where spreads are wide, and nothing to be
// had from those that are narrower than a fit can tell. Differs from the paper, which compares the energies
// of fits. Comparable between templates and options of one kind; may be below zero.
double choice_energy(const ShapeFit& fit, const PartTemplate& part_template, const ShapeSamples& samples,
                     const FitOptions& options);

}  // namespace archetype
