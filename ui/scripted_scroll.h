// Scrolling that a script asks for, as fast as a person turns the wheel, to measure how long frames take.
#pragma once

#include <optional>

namespace archetype {

struct UiState;

struct ScriptedScroll {
  bool clusters = false;  // false: the grid of the collection
  int frames = 1;
  int frame = 0;
  float direction = 1;  // turns round at the ends
};

// Wishes for the place of this frame; false once it is over.
bool advance(ScriptedScroll& scroll, UiState& ui, float scale);

}  // namespace archetype
