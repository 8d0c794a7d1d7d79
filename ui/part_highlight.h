// The part that is highlighted on all shapes and templates: that of the explorer's selection.
#pragma once

#include <optional>

#include "core/io/project.h"

namespace archetype {

struct Studio;

// The part of this template that is the highlighted one; nothing where none is, or the template lacks it.
std::optional<std::size_t> highlighted_part(Studio& studio, const PartTemplate& part_template);
// Highlights the part; the same once more, or none, lets go of it.
void select_part_of(Studio& studio, const TemplateRecord& record, std::optional<std::size_t> part);

}  // namespace archetype
