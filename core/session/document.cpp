#include "core/session/document.h"

#include <algorithm>

namespace archetype {

bool operator==(const Document& a, const Document& b) {
  return a.active == b.active &&
         std::equal(a.templates.begin(), a.templates.end(), b.templates.begin(), b.templates.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

}  // namespace archetype
