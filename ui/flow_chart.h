// Draws how the shapes move between templates: a column a round, a template as a picture of its boxes beside
// a bar as high as it has members, bands for the shapes that stay or move.
#pragma once

#include <imgui.h>

#include <optional>

#include "ui/learning_flow.h"
#include "ui/ui_state.h"

namespace archetype {

struct Studio;

// The colour of a line of templates: told apart also by colour-blind readers, and none of the parts' colours.
ImU32 line_colour(std::size_t line, float opacity = 1);

// Into the current window, at the cursor. `coming`: a round is under way, and a column is kept for it.
// Returns what was clicked: a template of a round ("learned:ROUND:NUMBER", from 0 and 1), or a round
// ("round:ROUND"). Of more rounds than have room the newest are shown when it is scrolled to the end, which
// it is by itself.
std::optional<LearningChoice> draw_flow_chart(Studio& studio, const std::vector<FlowColumn>& columns,
                                              const LearningRecord& record, const LearningChoice& chosen,
                                              bool coming, ImVec2 size);

}  // namespace archetype
