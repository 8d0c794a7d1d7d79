// The look of the window: colours, spacing, rounding.
#pragma once

#include <imgui.h>

#include <string_view>

#include "core/session/messages.h"

namespace archetype {

enum class Theme { dark, light };

Theme parse_theme(std::string_view name);  // "light"; anything else is dark

// The colours that panels ask for by meaning. The rest of Dear ImGui's colours are derived from them.
struct Palette {
  ImVec4 back;  // behind everything
  ImVec4 panel;
  ImVec4 raised;  // fields, buttons, cells
  ImVec4 hovered;
  ImVec4 border;
  ImVec4 text;
  ImVec4 muted;      // secondary text
  ImVec4 accent;     // what is selected or running
  ImVec4 on_accent;  // text on it
  ImVec4 good;
  ImVec4 warning;
  ImVec4 error;
};
const Palette& palette(Theme theme);

ImVec4 severity_colour(const Palette& colours, Severity severity);

// Sets the style of the current Dear ImGui context. `scale` is that of the screen: 1 at 96 dots per inch.
void apply_theme(Theme theme, float scale);

}  // namespace archetype
