// Turns the shapes of a project upright: `import --up auto`.
#pragma once

#include "core/base/job_control.h"
#include "core/io/project.h"

namespace archetype {

// Decides the up axes of all shapes together (geometry/upright.h) and turns the samples of those that were
// imported with `auto` and stand otherwise; what was known of those (fit, labels, thumbnails) goes. One
// transaction: all or, if cancelled, nothing. Returns the number of shapes that were turned.
std::size_t stand_upright(Project& project, unsigned threads, const JobControl& control);

}  // namespace archetype
