// The selected parts of the active template: UiState::part leads, and others are edited with it.
#pragma once

#include <functional>
#include <optional>

#include "core/session/actions.h"
#include "ui/ui_state.h"

namespace archetype {

struct Studio;

// The leading one first; empty while none is selected.
PartList selected_parts(const UiState& ui);
bool is_selected(const UiState& ui, std::size_t part);

void select_only(UiState& ui, std::optional<std::size_t> part);
// The first of them leads.
void select_all_of(UiState& ui, const PartList& parts);
// Takes the part in, as the leading one, or out again.
void toggle_selected(UiState& ui, std::size_t part);
// From the leading part to this one, as in a list with Shift held.
void select_up_to(UiState& ui, std::size_t part);
// Runs what goes through the history: parts stay selected by their names, so that no other one takes the
// place of one that is gone.
void step_through_history(Studio& studio, const std::function<void(History&)>& step);
// Drops what a template of so many parts does not have.
void keep_selection_within(UiState& ui, std::size_t part_count);

// The selected parts as they are shown, the leading one first.
std::vector<PlacedPart> selected_boxes(const Studio& studio);
// Whether these are the selected parts, and the committed document has them.
bool still_selected(const Studio& studio, const std::vector<PlacedPart>& placed);
// What the handles hold: the one box, or the box around all of them along the template's axes.
std::optional<Box> held_box(const std::vector<PlacedPart>& placed);

// What becomes of boxes held together as `from` when that is moved, turned or resized to `to`. A box that is
// turned against `from` keeps its angles and is stretched along its own axes.
std::vector<PlacedPart> carried(const std::vector<PlacedPart>& placed, const Box& from, const Box& to);

}  // namespace archetype
