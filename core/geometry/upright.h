// Which way up the shapes of a collection stand, decided together.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/geometry/shape_profile.h"
#include "core/model/shape.h"

namespace archetype {

inline constexpr std::size_t up_axis_count = 6;  // of UpAxis

// How a shape would look with each axis of its file pointing up.
struct UprightLook {
  std::array<ShapeProfile, up_axis_count> profiles{};
  // What speaks against each axis by itself, about -0.2 to 1: no vertical plane of symmetry, a centroid that
  // does not lie over what the shape stands on, little level surface.
  std::array<double, up_axis_count> oddness{};
};

// Does not depend on the up axis that the samples were made with. About 1 ms for 1,000 samples.
UprightLook look_upright(const ShapeSamples& samples);

// One up axis for each shape, so that the shapes look alike: least is the sum of each shape's distance to
// those most like it, of its oddness, and of a small preference for the usual axes (y, then z). A per-shape
// choice would leave chairs on their back and planes on their nose, which look as reasonable as upright ones.
// Up to 200 shapes, evenly chosen, are decided among each other by coordinate descent from each of the six
// axes; all others by comparison with them, so that the cost is linear in the collection. Deterministic; the
// order of equal shapes does not matter beyond the choice of the 200. Returns an empty list if cancelled.
std::vector<UpAxis> decide_upright(std::span<const UprightLook> looks, const JobControl& control);

}  // namespace archetype
