// The part that is highlighted on all shapes and templates: that of the explorer's selection.
#pragma once

#include <optional>

#include "core/io/project.h"

namespace archetype {

struct Studio;
struct ViewFit;

// The part of this template that is the highlighted one; nothing where none is, or the template lacks it.
std::optional<std::size_t> highlighted_part(Studio& studio, const PartTemplate& part_template);
// Whether the view of one shape highlights the picked part too: not once another box was selected there, and
// not where other views only follow the box that is selected here: that is edited with all labels seen.
bool highlights_in_shape_view(const Studio& studio);
// The part of the fit in view that keeps its colours then; no_such_part where its template lacks it.
std::optional<int> highlighted_in_view(Studio& studio, const ViewFit& fit);
// Highlights the part; the same once more, or none, lets go of it.
void select_part_of(Studio& studio, const TemplateRecord& record, std::optional<std::size_t> part);

}  // namespace archetype
