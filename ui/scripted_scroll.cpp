#include "ui/scripted_scroll.h"

#include <algorithm>

#include "ui/ui_state.h"

namespace archetype {

bool advance(ScriptedScroll& scroll, UiState& ui, float scale) {
  constexpr float step = 90;  // a notch of the wheel, about a cell's height: half a second for a screenful
  const float at = scroll.clusters ? ui.clusters.scroll : ui.grid.scroll;
  const float most = scroll.clusters ? ui.clusters.most_scroll : ui.grid.most_scroll;
  float next = at + scroll.direction * step * scale;
  if (next < 0 || next > most) scroll.direction = -scroll.direction;
  next = std::clamp(next, 0.0f, most);
  (scroll.clusters ? ui.clusters.wanted_scroll : ui.grid.wanted_scroll) = next;
  return ++scroll.frame < scroll.frames;
}

}  // namespace archetype
