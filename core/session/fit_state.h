// What a stored fit was made with, in one number.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/hash.h"
#include "core/fitting/fit_options.h"
#include "core/io/project.h"
#include "core/model/part_template.h"

namespace archetype {

// Every option by name, for records of what was done.
std::vector<std::pair<std::string, double>> named_options(const FitOptions& options);

// The key of the project's setting that keeps the options of the last fit_collection as JSON.
inline constexpr const char* fit_options_setting = "fit.options";

// Of everything that decides a fit besides the shape: templates, options and the program's way of fitting.
ContentHash fit_state(const std::vector<PartTemplate>& templates, const FitOptions& options);
// The same for one shape of the collection: where something of it was corrected, that too. Null: nothing.
ContentHash corrected_fit_state(const ContentHash& state, const ShapeCorrection* correction);

}  // namespace archetype
