// What the fits of the shapes that vote on yaws (AgreedYaws) reached. The project keeps it, so that one shape
// is fitted anew as soon as it is asked for, and as it would be together with all others.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/io/project.h"

namespace archetype {

using YawEnergies = std::vector<std::array<double, 4>>;  // one per reference

// Of all that they depend on: templates and options (fit_state()) and the references' samples.
ContentHash yaw_energies_state(const Project& project, const ContentHash& fit_state,
                               std::span<const ShapeId> references);

// Nothing if those that are kept are of another state, or are damaged.
std::optional<YawEnergies> kept_yaw_energies(const Project& project, const ContentHash& state,
                                             std::size_t references);
void keep_yaw_energies(Project& project, const ContentHash& state, const YawEnergies& energies);

}  // namespace archetype
