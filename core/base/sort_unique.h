// A list as a set.
#pragma once

#include <algorithm>
#include <vector>

namespace archetype {

// Ascending, each value once. (With std::unique: clang 14 cannot read what std::ranges::unique returns.)
template <typename T>
void sort_unique(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace archetype
