// The place that was pointed at on one shape, on others.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/session/fit_table.h"
#include "ui/explorer_selection.h"

namespace archetype {

struct Studio;

// From the mean box of its part to that of the same part of another template.
std::optional<Vec3> place_in(const FitTable& table, const PickedPlace& place, const PartTemplate& other,
                             std::size_t part);
// On the shape in view, as it is fitted while its boxes are edited: coordinates of the viewport's scene. At
// the sample of the part that is nearest to the place on the fitted box; nothing where the shape has no such
// part.
std::optional<glm::dvec3> picked_in_viewport(const Studio& studio);

}  // namespace archetype
