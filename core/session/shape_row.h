// What lists of a whole collection know of a shape, without its samples and faces.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/io/project.h"

namespace archetype {

struct ShapeRow {
  ShapeId id = 0;
  std::string name;
  std::size_t element_count = 0;
  ContentHash hash;  // of the file, when it was imported
  std::optional<FitSummary> fit;
};

}  // namespace archetype
