// Where an axis of a plot has its marks, and what they say.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace archetype {

// Round numbers for at most `most` marks between two values, at multiples of 1, 2 or 5 times a power of ten.
// At least two marks, one at or below `low` and one at or above `high`; most >= 3. Both finite.
std::vector<double> axis_marks(double low, double high, std::size_t most);

// With as many decimals as marks so far apart need; `step` > 0. Large and tiny numbers as 1.5e+07.
std::string mark_text(double value, double step);

}  // namespace archetype
