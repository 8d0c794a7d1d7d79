// The weights and limits of section 4.1.
#pragma once

#include <array>

namespace archetype {

struct FitOptions {
  std::array<bool, 4> yaws{true, true, true, true};  // candidate quarter turns about up to try
  int max_alternations = 100;                        // the paper's
};

}  // namespace archetype
