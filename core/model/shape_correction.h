// What a person said of one shape and its fit: fits and learning heed it from then on.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/hash.h"

namespace archetype {

// outlier: it is not learned from, and shown as one whatever its energy. learn: it is learned from however
// badly it fits.
enum class ShapeMark { none, outlier, learn };

// Samples whose part is given, by the name of the part ("": no part). Ascending, each sample once.
using PinnedParts = std::map<std::string, std::vector<std::uint32_t>>;

struct ShapeCorrection {
  std::optional<int> yaw_quarters = {};  // 0..3: no other yaw is tried
  std::string part_template = {};  // no template of another name is tried where there is one of this; "": any
  ShapeMark mark = ShapeMark::none;
  PinnedParts pinned = {};
  ContentHash sampling = {};  // of the shape that `pinned` speaks of: where it is sampled anew, that is void

  bool empty() const {
    return !yaw_quarters && part_template.empty() && mark == ShapeMark::none && pinned.empty();
  }
  friend bool operator==(const ShapeCorrection&, const ShapeCorrection&) = default;
};

}  // namespace archetype
