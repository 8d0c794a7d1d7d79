// Where the shape in view is its own mirror image, as the template sees it.
#pragma once

#include <array>

namespace archetype {

struct Studio;

// Whether the shape in view, turned by its fit, is symmetric across x = 0 (entry 0) and z = 0 (entry 1) of
// the template. Without a shape only the first: most things that stand upright are. About 2 ms.
std::array<bool, 2> symmetry_planes(const Studio& studio);

// 0 or 2: across which axis a part is mirrored unless it is said.
int symmetry_axis(const Studio& studio);

}  // namespace archetype
