// Keys to commands.
#pragma once

namespace archetype {

struct Studio;

// Runs the commands of the keys that were pressed since the last frame (studio.pressed_keys) and clears them.
// Keys that belong to a text field are left to it.
void run_shortcuts(Studio& studio);

}  // namespace archetype
