// The menu Part: which parts there are, and which are selected.
#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/session/actions.h"
#include "core/session/mirror_pairs.h"
#include "ui/command_groups.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/symmetry.h"

namespace archetype {
namespace {

const PartTemplate& active(const Studio& studio) {
  return *studio.history.committed().active_template();
}

PartList selected(const Studio& studio) {
  return selected_parts(studio.ui);
}

int axis_argument(Arguments arguments, std::string_view axes, int otherwise) {
  if (arguments.empty()) return otherwise;
  const std::string& text = arguments[0];
  if (text.size() != 1 || axes.find(text) == std::string_view::npos)
    throw Error("expected one of the axes " + std::string(axes) + ", not \"" + text + "\"");
  return text[0] - 'x';
}

// In the middle, of a size that can be taken hold of.
void add_command(Studio& studio, Arguments arguments) {
  Box box;
  box.half_extent = Vec3::Constant(0.3);
  const std::string name = arguments.empty() ? "part" : text_argument(arguments, 0, "a name");
  select_only(studio.ui, add_part(studio.history, box, name));
}

void duplicate_command(Studio& studio, Arguments) {
  select_all_of(studio.ui, duplicate_parts(studio.history, selected(studio)));
}

void mirror_command(Studio& studio, Arguments arguments) {
  const int axis = axis_argument(arguments, "xz", symmetry_axis(studio));
  select_all_of(studio.ui, add_mirror_images(studio.history, selected(studio), axis));
}

void link_command(Studio& studio, Arguments arguments) {
  const PartList parts = selected(studio);
  link_parts(studio.history, parts[0], parts[1], axis_argument(arguments, "xz", symmetry_axis(studio)));
}

void unlink_command(Studio& studio, Arguments) {
  unlink_parts(studio.history, selected(studio));
}

void delete_command(Studio& studio, Arguments) {
  remove_parts(studio.history, selected(studio));
  select_only(studio.ui, std::nullopt);
}

void merge_command(Studio& studio, Arguments) {
  select_only(studio.ui, merge_parts(studio.history, selected(studio)));
}

void split_command(Studio& studio, Arguments arguments) {
  Eigen::Index longest = 0;
  active(studio).parts[*studio.ui.part].scale.mean.maxCoeff(&longest);
  const int axis = axis_argument(arguments, "xyz", static_cast<int>(longest));
  select_all_of(studio.ui, split_part(studio.history, *studio.ui.part, axis));
}

void copy_command(Studio& studio, Arguments) {
  studio.ui.copied_parts.clear();
  PartList parts = selected(studio);
  std::sort(parts.begin(), parts.end());
  for (const std::size_t part : parts) studio.ui.copied_parts.push_back(active(studio).parts[part]);
  studio.ui.status = "Copied " + (parts.size() == 1 ? active(studio).parts[parts[0]].name
                                                    : std::to_string(parts.size()) + " parts");
}

void cut_command(Studio& studio, Arguments) {
  copy_command(studio, {});
  delete_command(studio, {});
}

void paste_command(Studio& studio, Arguments) {
  select_all_of(studio.ui, paste_parts(studio.history, studio.ui.copied_parts));
}

// What is dragged is what is selected, until the mouse lets go of it.
std::string needs_no_drag(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  return studio.history.has_preview() ? "let go of what you drag first" : "";
}

std::string needs_two_parts(const Studio& studio) {
  if (std::string reason = needs_part(studio); !reason.empty()) return reason;
  return selected(studio).size() >= 2 ? "" : "select two parts first: click the second with Ctrl held";
}

std::string needs_pair(const Studio& studio) {
  if (std::string reason = needs_two_parts(studio); !reason.empty()) return reason;
  return selected(studio).size() == 2 ? "" : "select only two parts";
}

std::string needs_link(const Studio& studio) {
  if (std::string reason = needs_part(studio); !reason.empty()) return reason;
  const PartList parts = selected(studio);
  const bool linked = std::any_of(parts.begin(), parts.end(), [&](std::size_t part) {
    return part < active(studio).parts.size() && active(studio).parts[part].mirror.pair > 0;
  });
  return linked ? "" : "it is not linked to a mirror image";
}

std::string needs_copied(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  return studio.ui.copied_parts.empty() ? "copy a part first" : "";
}

std::size_t part_argument(const Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "the name of a part");
  for (std::size_t i = 0; i < active(studio).parts.size(); ++i)
    if (active(studio).parts[i].name == name) return i;
  throw Error("the template has no part \"" + name + "\"");
}

void select_command(Studio& studio, Arguments arguments) {
  select_only(studio.ui, part_argument(studio, arguments));
}

void toggle_command(Studio& studio, Arguments arguments) {
  toggle_selected(studio.ui, part_argument(studio, arguments));
}

void select_all_command(Studio& studio, Arguments) {
  PartList all = selected(studio);
  for (std::size_t i = 0; i < active(studio).parts.size(); ++i)
    if (!is_selected(studio.ui, i)) all.push_back(i);
  select_all_of(studio.ui, all);
}

void next_command(Studio& studio, Arguments) {
  const std::size_t count = active(studio).parts.size();
  if (count > 0) select_only(studio.ui, studio.ui.part ? (*studio.ui.part + 1) % count : 0);
}

}  // namespace

void add_part_list_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "add-part",
                                       .title = "Add part",
                                       .menu = "Part",
                                       .key = "Shift+A",
                                       .arguments = "[NAME]",
                                       .run = add_command,
                                       .why_not = needs_template,
                                       .edits = true},
                                      {.name = "duplicate-part",
                                       .title = "Duplicate part",
                                       .menu = "Part",
                                       .key = "Ctrl+D",
                                       .run = duplicate_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "mirror-part",
                                       .title = "Mirror part",
                                       .menu = "Part",
                                       .key = "Ctrl+M",
                                       .arguments = "[x|z]",
                                       .run = mirror_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "link-parts",
                                       .title = "Link two parts as mirror images",
                                       .menu = "Part",
                                       .key = "Shift+M",
                                       .arguments = "[x|z]",
                                       .run = link_command,
                                       .why_not = needs_pair,
                                       .edits = true},
                                      {.name = "unlink-parts",
                                       .title = "Unlink from the mirror image",
                                       .menu = "Part",
                                       .key = "U",
                                       .run = unlink_command,
                                       .why_not = needs_link,
                                       .edits = true},
                                      {.name = "merge-parts",
                                       .title = "Merge parts",
                                       .menu = "Part",
                                       .key = "M",
                                       .run = merge_command,
                                       .why_not = needs_two_parts,
                                       .edits = true},
                                      {.name = "split-part",
                                       .title = "Split part in two",
                                       .menu = "Part",
                                       .key = "K",
                                       .arguments = "[x|y|z]",
                                       .run = split_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "delete-part",
                                       .title = "Delete part",
                                       .menu = "Part",
                                       .key = "Delete",
                                       .run = delete_command,
                                       .why_not = needs_part,
                                       .edits = true},
                                      {.name = "cut-parts",
                                       .title = "Cut parts",
                                       .menu = "Edit",
                                       .key = "Ctrl+X",
                                       .run = cut_command,
                                       .why_not = needs_part,
                                       .separator = true,
                                       .edits = true},
                                      {.name = "copy-parts",
                                       .title = "Copy parts",
                                       .menu = "Edit",
                                       .key = "Ctrl+C",
                                       .run = copy_command,
                                       .why_not = needs_part},
                                      {.name = "paste-parts",
                                       .title = "Paste parts into this template",
                                       .menu = "Edit",
                                       .key = "Ctrl+V",
                                       .run = paste_command,
                                       .why_not = needs_copied,
                                       .edits = true},
                                      {.name = "next-part",
                                       .title = "Select the next part",
                                       .menu = "Edit",
                                       .key = "Tab",
                                       .run = next_command,
                                       .why_not = needs_no_drag,
                                       .separator = true},
                                      {.name = "select-all-parts",
                                       .title = "Select all parts",
                                       .menu = "Edit",
                                       .key = "Ctrl+A",
                                       .run = select_all_command,
                                       .why_not = needs_no_drag},
                                      {.name = "select-part",
                                       .title = "Select a part",
                                       .arguments = "NAME",
                                       .run = select_command,
                                       .why_not = needs_no_drag},
                                      {.name = "toggle-part",
                                       .title = "Take a part into the selection, or out",
                                       .arguments = "NAME",
                                       .run = toggle_command,
                                       .why_not = needs_no_drag},
                                  });
}

}  // namespace archetype
