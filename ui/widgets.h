// Small things that panels share.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "ui/command.h"

namespace archetype {

struct Studio;

// Records the item drawn last under a name, so that tests and scripts can find it and really click it.
void mark_target(Studio& studio, std::string name);

// ImGui::Button(), whose label stays in the middle also where there is no room for the padding.
bool sized_button(const char* label, ImVec2 size);
// A button for a command: greyed out with the reason as a tooltip where it cannot be used; else its title and
// key. `label` may hold an icon. Marked as "command:NAME".
bool command_button(Studio& studio, std::string_view name, const std::string& label, ImVec2 size = {0, 0});
// The same, drawn pressed while the command's switch is on.
bool command_toggle(Studio& studio, std::string_view name, const std::string& label);
void command_menu_item(Studio& studio, const Command& command);

void section_title(const Studio& studio, const char* title);
// What an empty panel says: what it is for and what to do next.
void empty_hint(const Studio& studio, const char* title, const char* hint);
void muted_text(const Studio& studio, std::string_view text);
// Wrapped at the edge of the panel.
void muted_paragraph(const Studio& studio, const char* text);
void tooltip(const char* text);  // of the item drawn last, also when it is disabled

// A text cut to a width with "…" at its end.
std::string fitted(const std::string& text, float width);
std::string duration_text(double seconds);                        // "8 s", "3 min 20 s", "1 h 5 min"
std::string plural(std::size_t count, const std::string& thing);  // "1 shape", "2 shapes"
std::string count_text(std::size_t count);                        // "12,345"

// A line between groups of buttons in a row; the next item follows on the same line.
void separator_in_line(const Studio& studio);
float separator_width(const Studio& studio);  // with the gaps on its two sides
// Buttons in a row as wide as the panel.
float share_of_width(int columns);

}  // namespace archetype
