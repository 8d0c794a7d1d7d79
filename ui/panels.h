// The panels, one file each. A panel is a function of what it is handed: it owns nothing and keeps nothing.
#pragma once

#include <span>

namespace archetype {

struct Studio;

// Their content; frame.cpp makes the windows around them.
void draw_collection_panel(Studio& studio);
void draw_template_panel(Studio& studio);  // the templates and the list of parts
void draw_compare_panel(Studio& studio);   // how another template differs
void draw_part_panel(Studio& studio);      // the numbers of the selected part
void draw_fit_panel(Studio& studio);       // the energy of the shape in view
void draw_strip_panel(Studio& studio);     // other shapes, fitted while a box is dragged
void draw_jobs_panel(Studio& studio);
void draw_learning_panel(Studio& studio);  // how templates are learned, round by round
void draw_messages_panel(Studio& studio);
void draw_history_panel(Studio& studio);
void draw_diagnostics_panel(Studio& studio);
void draw_tool_bar(Studio& studio);
void draw_cloud_tools(Studio& studio);
void draw_cloud(Studio& studio);  // all points of many shapes in one space
void draw_status_bar(Studio& studio);
void draw_plots_tools(Studio& studio);
void draw_plots_view(Studio& studio);

// Whole windows of their own, drawn only while they are open.
void draw_menu_bar(Studio& studio);
void draw_command_palette(Studio& studio);
void draw_help_window(Studio& studio);
void draw_about_window(Studio& studio);
void draw_suggestions_window(Studio& studio);

struct Panel {
  const char* name;
  void (*draw)(Studio&);
};
// Those of the first group: for tests, which draw each of them alone.
std::span<const Panel> all_panels();

}  // namespace archetype
