// What is done from the view of a single fit: corrections of the shape in view, the next fit, another shape
// beside it. All throw Error with a line for a person where they cannot be done.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/shape_correction.h"
#include "core/session/correction_actions.h"
#include "ui/inspect_options.h"

namespace archetype {

struct Studio;

// The shape in view; with others selected together with it, all of them.
NamedShape shape_in_view(const Studio& studio);
std::vector<NamedShape> shapes_to_correct(const Studio& studio);

// What is shown becomes what the shape has to take.
void pin_shown(Studio& studio);
// Fits those shapes anew whose fits are not of the project's templates and of what was corrected.
void refit_outdated(Studio& studio);
// Another member of the cluster comes beside the shape in view: the next one in the order of names (1), or
// the one before (-1).
void step_beside(Studio& studio, int step);

}  // namespace archetype
