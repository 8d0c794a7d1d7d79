// The families by name, for those who generate and describe them.
#pragma once

#include <string>

#include "core/generate/family.h"
#include "core/generate/generate.h"

namespace archetype {

// Throws PreconditionError for an unknown name.
Family find_family(const std::string& name);

// As generate_shape() with the family's name, without looking it up for every shape.
GeneratedShape generate_shape(const Family& family, const GenerateOptions& options, std::size_t index);

}  // namespace archetype
