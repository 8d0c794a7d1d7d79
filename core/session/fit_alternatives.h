// What a shape would be by other templates and other yaws.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_correction.h"
#include "core/model/shape_fit.h"

namespace archetype {

struct FitAlternative {
  std::size_t part_template = 0;  // an index into those that were given
  ShapeFit fit;                   // at one yaw
  double choice = 0;              // choice_energy(): what templates are compared by
  std::vector<ShapeFit> steps;    // its alternations: the start, and after each (FitRecording)
};

// The fit of each template at each of the four yaws, by template and then yaw; pinned samples hold, pinned
// yaws and templates do not. What cannot be fitted is left out. Nothing if cancelled. About 40 ms for each
// template of 1,000 samples and 8 parts, and half as much for each of the yaws.
std::optional<std::vector<FitAlternative>> fit_alternatives(std::span<const PartTemplate> templates,
                                                            const ShapeSamples& samples,
                                                            const PinnedParts& pinned,
                                                            const FitOptions& options,
                                                            const JobControl& control);

}  // namespace archetype
