// The parts of the command table, one file each.
#pragma once

#include <string>
#include <vector>

#include "ui/command.h"

namespace archetype {

void add_file_commands(std::vector<Command>& commands);
void add_edit_commands(std::vector<Command>& commands);
void add_template_commands(std::vector<Command>& commands);
void add_part_list_commands(std::vector<Command>& commands);
void add_part_commands(std::vector<Command>& commands);
void add_point_commands(std::vector<Command>& commands);
void add_view_commands(std::vector<Command>& commands);
void add_clusters_commands(std::vector<Command>& commands);
void add_filter_commands(std::vector<Command>& commands);
void add_cloud_commands(std::vector<Command>& commands);
void add_figure_commands(std::vector<Command>& commands);
void add_strip_commands(std::vector<Command>& commands);
void add_fit_commands(std::vector<Command>& commands);
void add_inspect_commands(std::vector<Command>& commands);
void add_correction_commands(std::vector<Command>& commands);
void add_learning_commands(std::vector<Command>& commands);
void add_plot_commands(std::vector<Command>& commands);
void add_help_commands(std::vector<Command>& commands);
void add_quit_command(std::vector<Command>& commands);  // below all others of its menu

// Shared conditions, for Command::why_not: a hint on what to do first, or "".
std::string needs_collection(const Studio& studio);
std::string needs_any_shape(const Studio& studio);  // in view, or to be named
std::string needs_shape(const Studio& studio);
std::string needs_template(const Studio& studio);
std::string needs_part(const Studio& studio);
std::string needs_free_shapes(const Studio& studio);  // that no job fits
std::string needs_shapes_and_template(const Studio& studio);
std::string needs_fit(const Studio& studio);        // of the active template as it is, to the shape in view
std::string needs_inspected(const Studio& studio);  // that the view of a single fit shows a shape

// Arguments of scripts. Throw Error with what was expected.
double number_argument(Arguments arguments, std::size_t index, std::string_view what);
// In quarters: 0, 90, 180 or 270 degrees.
int yaw_argument(Arguments arguments, std::size_t index);
// All arguments from `first` on as one text with blanks, so that names need no quotes.
std::string text_argument(Arguments arguments, std::size_t first, std::string_view what);

}  // namespace archetype
