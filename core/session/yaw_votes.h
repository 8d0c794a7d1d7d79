// What the other shapes of a project say of the yaw of one (AgreedYaws): which shapes are asked, and what
// comes of it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/io/project.h"
#include "core/session/learned_yaws.h"

namespace archetype {

// Shapes whose yaws are known, and others spread over the whole collection, whatever is fitted already: a run
// that was stopped goes on with the same.
std::vector<ShapeId> yaw_voters(const Project& project, const KnownYaws& known);

// What each yaw of a shape costs beside the energies of its fits, where its templates are those of the
// project and nothing of it is pinned: as fit_collection() counts it. Infinite for yaws that are not tried.
// Nothing if the project keeps no votes of its templates and FitOptions{}, or if cancelled. About 0.2 s.
std::optional<std::array<double, 4>> kept_yaw_costs(const Project& project, ShapeId shape,
                                                    const JobControl& control);

}  // namespace archetype
