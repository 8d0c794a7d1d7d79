#include "ui/shortcuts.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "ui/recovery.h"
#include "ui/studio.h"

namespace archetype {
namespace {

bool is_for_text_field(const Studio& studio, const KeyChord& chord) {
  if (!ImGui::GetIO().WantTextInput || works_in_text_fields(chord)) return false;
  // In the palette and the file browser Esc closes the window; elsewhere it takes back what was typed.
  return chord.key != "Escape" || (!studio.ui.palette.open && !studio.ui.browser.open);
}

// Chooses among the suggested templates.
bool is_for_suggestions(const Studio& studio, const KeyChord& chord) {
  return studio.ui.show_suggestions && !studio.ui.palette.open &&
         (chord.key == "Left" || chord.key == "Right" || chord.key == "Up" || chord.key == "Down");
}

// Dear ImGui takes Home, Esc and the arrows for a walk among its widgets, too, and would frame the one that
// it comes to and show its tooltip.
void take_from_widgets() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGui::NavMoveRequestCancel();
  context.NavInitRequest = false;
  context.NavDisableHighlight = true;
  context.NavDisableMouseHover = false;
}

}  // namespace

void run_shortcuts(Studio& studio) {
  for (const KeyChord& chord : std::exchange(studio.pressed_keys, {})) {
    const bool asks = asks_to_close(studio) || offers_recovery(studio);
    const auto is_key_of = [&](const char* command) {
      return to_string(chord) == key_of(studio, *find_command(studio, command));
    };
    const bool meant = chord.key == "Escape" || is_key_of("picture") || is_key_of("quit");
    if (asks && !meant) continue;
    if (take_new_key(studio, chord)) continue;
    if (is_for_text_field(studio, chord) || is_for_suggestions(studio, chord)) continue;
    if (take_transform_key(studio, chord)) continue;
    const std::string text = to_string(chord);
    const auto command = std::find_if(studio.commands.begin(), studio.commands.end(),
                                      [&](const Command& each) { return key_of(studio, each) == text; });
    if (command == studio.commands.end()) continue;
    take_from_widgets();
    run_command(studio, command->name);
  }
}

}  // namespace archetype
