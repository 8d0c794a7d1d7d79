// Which of several templates a shape takes.
#pragma once

#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape_fit.h"

namespace archetype {

// The energy of the fit with what its template's spreads cost: the logarithms of the standard deviations that
// make Gaussians of equations 5 and 6 densities. Without them a template that expects nothing in particular
// would fit every shape best. Comparable between templates and options of one kind; may be below zero.
double choice_energy(const ShapeFit& fit, const PartTemplate& part_template, const FitOptions& options);

}  // namespace archetype
