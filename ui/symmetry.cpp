#include "ui/symmetry.h"

#include <utility>

#include "core/learning/mirror_symmetry.h"
#include "ui/studio.h"

namespace archetype {

std::array<bool, 2> symmetry_planes(const Studio& studio) {
  if (!studio.shape.samples) return {true, false};
  std::array<bool, 2> planes = mirror_planes(*studio.shape.samples);
  const bool turned = studio.shape.fit && studio.shape.fit->fit.yaw_quarters % 2 != 0;
  if (turned) std::swap(planes[0], planes[1]);
  return planes;
}

int symmetry_axis(const Studio& studio) {
  const std::array<bool, 2> planes = symmetry_planes(studio);
  return planes[1] && !planes[0] ? 2 : 0;
}

}  // namespace archetype
