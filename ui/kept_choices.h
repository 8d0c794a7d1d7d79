// What the explorer shows, as the settings have it: commands change the settings, views look at UiState.
#pragma once

#include <optional>
#include <string_view>

#include "ui/inspect_options.h"

namespace archetype {

struct Studio;

// Once a frame, before its panels.
void follow_kept_choices(Studio& studio);

// As the settings and the commands call it: "distance".
std::optional<InspectColour> find_inspect_colour(std::string_view name);
std::string_view name_of(InspectColour colour);

}  // namespace archetype
