// The end of the program within a bounded time.
#pragma once

#include <chrono>

namespace archetype {

// Ends the process with `status` if it has not ended by itself after `grace`. Work beside the window is told
// to stop, but has a low priority: where others take all processors it may hear of that only many seconds
// later. To be called once all is saved that shall be: what still runs then is cut off wherever it is, as if
// the program were killed, which projects survive.
void end_within(std::chrono::milliseconds grace, int status);

}  // namespace archetype
