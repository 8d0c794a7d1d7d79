// How much memory a piece of a test takes from the heap.
#pragma once

#include <cstddef>

namespace archetype::test {

// Forgets the peak so far. All threads of the program count together.
void reset_peak_memory();
// The most bytes held at once through operator new since then, beyond what was held at that moment.
std::size_t peak_memory();

}  // namespace archetype::test
