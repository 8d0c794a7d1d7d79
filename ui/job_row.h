// A job that runs, as the panels show it: what it does, how far it is, buttons to pause and to stop it.
#pragma once

#include <string>

#include "core/session/jobs.h"

namespace archetype {

struct Studio;

// As wide as the panel; `note` follows what it does. Targets: "pause:TITLE" (also while it is paused) and
// "stop:TITLE".
void draw_active_job(Studio& studio, const JobView& job, const std::string& note = {});

}  // namespace archetype
