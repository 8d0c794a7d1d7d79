#include "ui/scripted_drag.h"

#include <cmath>
#include <numbers>

#include "core/session/actions.h"

namespace archetype {

bool advance(ScriptedDrag& drag, History& history) {
  const PartTemplate* active = history.committed().active_template();
  if (!active || drag.part >= active->parts.size()) {  // deleted, or undone, while the script goes on
    history.cancel_preview();
    return false;
  }
  const double done = static_cast<double>(++drag.frame) / drag.frames;
  Box box = drag.from;
  box.centre += std::sin(done * std::numbers::pi / 2) * drag.by;
  const bool last = drag.frame >= drag.frames;
  set_part_box(history, drag.part, box, last ? Stage::done : Stage::live);
  return !last;
}

}  // namespace archetype
