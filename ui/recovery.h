// After the program was killed or crashed: the next start offers what was open.
#pragma once

namespace archetype {

struct Studio;

// Finds what earlier sessions left, and begins one that would leave its own. For a window that a person sits
// at.
void begin_session(Studio& studio);
// Another project is in view. One that an earlier session left open needs no offer any more.
void note_open_project(Studio& studio);
bool offers_recovery(const Studio& studio);
void draw_recovery_window(Studio& studio);
// The offer is put off: projects open with their folder or file as ever; templates that are in no project are
// offered again by the next start.
void close_recovery(Studio& studio);

}  // namespace archetype
