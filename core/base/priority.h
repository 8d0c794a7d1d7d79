// Which threads go first where there are more of them than cores.
#pragma once

namespace archetype {

// Drawing comes first, then what somebody waits for while a box moves, then long work.
enum class Priority { answer, job };

// For the calling thread and those that it starts from now on; for good.
void lower_priority(Priority to);

}  // namespace archetype
