// Joins vertices at exactly the same place, for formats that repeat them in every face.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/vector.h"

namespace archetype {

// Appends to `vertices` what this welder has not added yet. Exactly equal coordinates only (0 and -0 are
// equal): no tolerance, so that no face collapses. Constant time per vertex.
class VertexWelder {
 public:
  // `expected`: how many vertices will be added, with repetitions; only a hint. `vertices` is referred to.
  VertexWelder(std::vector<Vec3>& vertices, std::size_t expected);
  std::uint32_t add(const Vec3& vertex);

 private:
  static constexpr std::uint32_t empty = 0xFFFFFFFF;
  std::size_t find_slot(const Vec3& vertex) const;
  void grow();

  std::vector<Vec3>& vertices_;
  std::size_t first_;                 // what stood in vertices_ before is left alone
  std::vector<std::uint32_t> slots_;  // open addressing; a power of two, at most half full
};

}  // namespace archetype
