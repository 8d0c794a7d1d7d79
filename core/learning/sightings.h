// Fits of one template to many shapes, and what they say of its parts.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/geometry/vector.h"
#include "core/learning/reestimate.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_correction.h"

namespace archetype {

// A shape to learn from, and what its yaws cost beside their energies (FitOptions::yaw_costs).
struct LearningShape {
  const ShapeSamples* samples = nullptr;
  std::array<double, 4> yaw_costs{};
  const ShapeCorrection* correction = nullptr;  // by hand, of these samples; null: none
};

// All that learning needs of a fit.
struct Sighting {
  double choice = std::numeric_limits<double>::infinity();  // choice_energy(), and the cost of the yaw
  double energy = 0;                                        // the fit's own
  double misfit = 0;                                        // of it, E_data
  std::array<double, 4> yaw_energies{};                     // of the fit
  int yaw_quarters = 0;                                     // of the fit
  Bounds bounds;                                            // of the samples, in the template's frame
  std::vector<PartObservation> parts;  // one per part of the template; the boxes are those of free_boxes()
};

// The template fitted to each of the shapes, in their order, with the labels that are pinned. Nothing if
// cancelled. Deterministic whatever the number of threads.
std::optional<std::vector<Sighting>> sightings(const PartTemplate& part_template,
                                               std::span<const LearningShape> shapes,
                                               const FitOptions& options, unsigned threads,
                                               const JobControl& control);

}  // namespace archetype
