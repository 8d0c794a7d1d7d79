// The menu Part: the numbers of the selected parts.
#include <Eigen/Geometry>
#include <numbers>

#include "core/base/error.h"
#include "core/model/part_colours.h"
#include "core/session/actions.h"
#include "ui/box_angles.h"
#include "ui/command_groups.h"
#include "ui/selection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

const PartTemplate& active(const Studio& studio) {
  return *studio.history.committed().active_template();
}

Box selected_box(const Studio& studio) {
  return active(studio).parts[*studio.ui.part].mean_box();
}

Vec3 vector_argument(Arguments arguments) {
  return {number_argument(arguments, 0, "x y z"), number_argument(arguments, 1, "x y z"),
          number_argument(arguments, 2, "x y z")};
}

void rename_command(Studio& studio, Arguments arguments) {
  if (arguments.empty()) {
    studio.ui.wanted_name = true;
    return;
  }
  rename_part(studio.history, *studio.ui.part, text_argument(arguments, 0, "a name"));
}

void position_command(Studio& studio, Arguments arguments) {
  Box box = selected_box(studio);
  box.centre = vector_argument(arguments);
  set_part_box(studio.history, *studio.ui.part, box);
}

void size_command(Studio& studio, Arguments arguments) {
  Box box = selected_box(studio);
  box.half_extent = vector_argument(arguments);
  if (box.half_extent.minCoeff() <= 0) throw Error("half extents have to be above 0");
  set_part_box(studio.history, *studio.ui.part, box);
}

void rotation_command(Studio& studio, Arguments arguments) {
  Box box = selected_box(studio);
  box.orientation = orientation_of_degrees(vector_argument(arguments));
  set_part_box(studio.history, *studio.ui.part, box);
}

void position_spread_command(Studio& studio, Arguments arguments) {
  set_position_stddev(studio.history, selected_parts(studio.ui), vector_argument(arguments));
}

void size_spread_command(Studio& studio, Arguments arguments) {
  set_scale_stddev(studio.history, selected_parts(studio.ui), vector_argument(arguments));
}

void label_command(Studio& studio, Arguments arguments) {
  const double label = number_argument(arguments, 0, "a whole number from 0");
  if (label < 0 || label > 32'000 || label != static_cast<int>(label))
    throw Error("a label is a whole number from 0");
  set_part_label(studio.history, selected_parts(studio.ui), static_cast<int>(label));
}

void colour_command(Studio& studio, Arguments arguments) {
  int colour = -1;
  if (text_argument(arguments, 0, "a number or auto") != "auto") {
    const double number = number_argument(arguments, 0, "a number or auto");
    if (number < 0 || number >= part_colour_count || number != static_cast<int>(number))
      throw Error("colours have the numbers 0 to " + std::to_string(part_colour_count - 1));
    colour = static_cast<int>(number);
  }
  set_part_colour(studio.history, selected_parts(studio.ui), colour);
}

void must_exist_command(Studio& studio, Arguments arguments) {
  const bool now = active(studio).parts[*studio.ui.part].must_exist;
  const bool wanted = arguments.empty() ? !now : text_argument(arguments, 0, "yes or no") == "yes";
  set_must_exist(studio.history, selected_parts(studio.ui), wanted);
}

void existence_command(Studio& studio, Arguments arguments) {
  const double existence = number_argument(arguments, 0, "a share above 0, at most 1");
  if (existence <= 0 || existence > 1) throw Error("existence is above 0 and at most 1");
  set_existence(studio.history, selected_parts(studio.ui), existence);
}

bool must_exist_checked(const Studio& studio) {
  const PartTemplate* shown = studio.history.current().active_template();
  return shown && studio.ui.part && *studio.ui.part < shown->parts.size() &&
         shown->parts[*studio.ui.part].must_exist;
}

}  // namespace

void add_part_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "must-exist",
                                       .title = "Must exist",
                                       .menu = "Part",
                                       .arguments = "[yes|no]",
                                       .run = must_exist_command,
                                       .why_not = needs_part,
                                       .checked = must_exist_checked,
                                       .edits = true},
                                      {.name = "rename-part",
                                       .title = "Rename the part",
                                       .menu = "Part",
                                       .key = "F2",
                                       .arguments = "[NAME]",
                                       .run = rename_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-position",
                                       .title = "Put the part at",
                                       .arguments = "X Y Z",
                                       .run = position_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-size",
                                       .title = "Half extents of the part",
                                       .arguments = "X Y Z",
                                       .run = size_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-rotation",
                                       .title = "Rotation of the part, degrees",
                                       .arguments = "X Y Z",
                                       .run = rotation_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-position-spread",
                                       .title = "Spread of the position",
                                       .arguments = "X Y Z",
                                       .run = position_spread_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-size-spread",
                                       .title = "Spread of the size",
                                       .arguments = "X Y Z",
                                       .run = size_spread_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-label",
                                       .title = "Label of the part",
                                       .arguments = "NUMBER",
                                       .run = label_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-colour",
                                       .title = "Colour of the part",
                                       .arguments = "NUMBER|auto",
                                       .run = colour_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "set-existence",
                                       .title = "Existence of the part",
                                       .arguments = "SHARE",
                                       .run = existence_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                  });
}

}  // namespace archetype
