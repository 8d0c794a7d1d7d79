#include "core/base/random.h"

#include <cmath>
#include <numbers>

namespace archetype {

double RandomStream::normal() {
  const double u = 1.0 - uniform();  // in (0, 1], so that the logarithm is finite
  const double v = uniform();
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
}

}  // namespace archetype
