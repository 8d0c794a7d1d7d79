#include "core/session/document.h"

#include <algorithm>

namespace archetype {

bool operator==(const Document& a, const Document& b) {
  return a.active == b.active && same_corrections(a.corrections, b.corrections) &&
         std::equal(a.templates.begin(), a.templates.end(), b.templates.begin(), b.templates.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

const ShapeCorrection* correction_of(const Document& document, ShapeId shape) {
  if (!document.corrections) return nullptr;
  const auto found = document.corrections->find(shape);
  return found == document.corrections->end() ? nullptr : found->second.get();
}

}  // namespace archetype
