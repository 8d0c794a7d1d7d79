// One frame of the whole window.
#pragma once

namespace archetype {

struct Studio;

// Between ImGui::NewFrame() and ImGui::Render(): everything there is, laid out over the main viewport.
void draw_frame(Studio& studio);

}  // namespace archetype
