// A drag that a script asks for: the live edits that a mouse would make, one a frame, then one commit.
#pragma once

#include "core/geometry/box.h"
#include "core/session/history.h"

namespace archetype {

struct ScriptedDrag {
  std::size_t part = 0;
  Box from;
  Vec3 by = Vec3::Zero();  // the whole way, slowing down towards its end
  int frames = 1;
  int frame = 0;
};

// Makes the edit of this frame; false once the drag is over.
bool advance(ScriptedDrag& drag, History& history);

}  // namespace archetype
