// How the energy of the fits of one template is spread over its shapes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/evaluation/fit_inspection.h"
#include "core/io/project.h"

namespace archetype {

// Of each term of energy_terms the values of the shapes, ascending.
using TermValues = std::array<std::vector<double>, energy_terms.size()>;

struct ClusterTerms {
  std::size_t shapes = 0;         // that were looked at
  TermValues whole;               // of the whole fit
  std::vector<TermValues> parts;  // of each part, on the shapes that have it
};

// Of the shapes that are fitted by a template, at most `most`, spread over the cluster. Some milliseconds a
// shape. Nothing if cancelled. Throws FileError.
std::optional<ClusterTerms> cluster_terms(const Project& project, TemplateId part_template, std::size_t most,
                                          const FitOptions& options, const JobControl& control);

}  // namespace archetype
