// The menu Part: parts of the active template.
#include <Eigen/Geometry>
#include <numbers>

#include "core/base/error.h"
#include "core/session/actions.h"
#include "ui/box_angles.h"
#include "ui/command_groups.h"
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

// In the middle, of a size that can be taken hold of.
void add_command(Studio& studio, Arguments arguments) {
  Box box;
  box.half_extent = Vec3::Constant(0.3);
  const std::size_t part = add_part(studio.history, box);
  if (!arguments.empty()) rename_part(studio.history, part, text_argument(arguments, 0, "a name"));
  studio.ui.part = part;
}

void duplicate_command(Studio& studio, Arguments) {
  studio.ui.part = duplicate_part(studio.history, *studio.ui.part);
}

void mirror_command(Studio& studio, Arguments) {
  studio.ui.part = mirror_part(studio.history, *studio.ui.part);
}

void delete_command(Studio& studio, Arguments) {
  remove_part(studio.history, *studio.ui.part);
  studio.ui.part.reset();
}

// What is dragged is the selected part, until the mouse lets go of it.
std::string needs_no_drag(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  return studio.history.has_preview() ? "let go of what you drag first" : "";
}

void select_command(Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "the name of a part");
  for (std::size_t i = 0; i < active(studio).parts.size(); ++i)
    if (active(studio).parts[i].name == name) {
      studio.ui.part = i;
      return;
    }
  throw Error("the template has no part \"" + name + "\"");
}

void next_command(Studio& studio, Arguments) {
  const std::size_t count = active(studio).parts.size();
  if (count > 0) studio.ui.part = studio.ui.part ? (*studio.ui.part + 1) % count : 0;
}

void rename_command(Studio& studio, Arguments arguments) {
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
  set_position_stddev(studio.history, *studio.ui.part, vector_argument(arguments));
}

void size_spread_command(Studio& studio, Arguments arguments) {
  set_scale_stddev(studio.history, *studio.ui.part, vector_argument(arguments));
}

void label_command(Studio& studio, Arguments arguments) {
  const double label = number_argument(arguments, 0, "a whole number from 0");
  if (label < 0 || label > 32'000 || label != static_cast<int>(label))
    throw Error("a label is a whole number from 0");
  set_part_label(studio.history, *studio.ui.part, static_cast<int>(label));
}

void must_exist_command(Studio& studio, Arguments arguments) {
  const bool now = active(studio).parts[*studio.ui.part].must_exist;
  const bool wanted = arguments.empty() ? !now : text_argument(arguments, 0, "yes or no") == "yes";
  set_must_exist(studio.history, *studio.ui.part, wanted);
}

void existence_command(Studio& studio, Arguments arguments) {
  const double existence = number_argument(arguments, 0, "a share above 0, at most 1");
  if (existence <= 0 || existence > 1) throw Error("existence is above 0 and at most 1");
  set_existence(studio.history, *studio.ui.part, existence);
}

bool must_exist_checked(const Studio& studio) {
  const PartTemplate* shown = studio.history.current().active_template();
  return shown && studio.ui.part && *studio.ui.part < shown->parts.size() &&
         shown->parts[*studio.ui.part].must_exist;
}

}  // namespace

void add_part_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "add-part",
                                       .title = "Add part",
                                       .menu = "Part",
                                       .key = "Shift+A",
                                       .arguments = "[NAME]",
                                       .run = add_command,
                                       .why_not = needs_template},
                                      {.name = "duplicate-part",
                                       .title = "Duplicate part",
                                       .menu = "Part",
                                       .key = "Ctrl+D",
                                       .run = duplicate_command,
                                       .why_not = needs_part},
                                      {.name = "mirror-part",
                                       .title = "Mirror part",
                                       .menu = "Part",
                                       .key = "Ctrl+M",
                                       .run = mirror_command,
                                       .why_not = needs_part},
                                      {.name = "delete-part",
                                       .title = "Delete part",
                                       .menu = "Part",
                                       .key = "Delete",
                                       .run = delete_command,
                                       .why_not = needs_part},
                                      {.name = "next-part",
                                       .title = "Select the next part",
                                       .menu = "Part",
                                       .key = "Tab",
                                       .run = next_command,
                                       .why_not = needs_no_drag,
                                       .separator = true},
                                      {.name = "must-exist",
                                       .title = "Must exist",
                                       .menu = "Part",
                                       .arguments = "[yes|no]",
                                       .run = must_exist_command,
                                       .why_not = needs_part,
                                       .checked = must_exist_checked},
                                      {.name = "select-part",
                                       .title = "Select a part",
                                       .arguments = "NAME",
                                       .run = select_command,
                                       .why_not = needs_no_drag},
                                      {.name = "rename-part",
                                       .title = "Rename the part",
                                       .arguments = "NAME",
                                       .run = rename_command,
                                       .why_not = needs_part},
                                      {.name = "set-position",
                                       .title = "Put the part at",
                                       .arguments = "X Y Z",
                                       .run = position_command,
                                       .why_not = needs_part},
                                      {.name = "set-size",
                                       .title = "Half extents of the part",
                                       .arguments = "X Y Z",
                                       .run = size_command,
                                       .why_not = needs_part},
                                      {.name = "set-rotation",
                                       .title = "Rotation of the part, degrees",
                                       .arguments = "X Y Z",
                                       .run = rotation_command,
                                       .why_not = needs_part},
                                      {.name = "set-position-spread",
                                       .title = "Spread of the position",
                                       .arguments = "X Y Z",
                                       .run = position_spread_command,
                                       .why_not = needs_part},
                                      {.name = "set-size-spread",
                                       .title = "Spread of the size",
                                       .arguments = "X Y Z",
                                       .run = size_spread_command,
                                       .why_not = needs_part},
                                      {.name = "set-label",
                                       .title = "Label of the part",
                                       .arguments = "NUMBER",
                                       .run = label_command,
                                       .why_not = needs_part},
                                      {.name = "set-existence",
                                       .title = "Existence of the part",
                                       .arguments = "SHARE",
                                       .run = existence_command,
                                       .why_not = needs_part},
                                  });
}

}  // namespace archetype
