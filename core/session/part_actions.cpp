// Edits of what the parts of the active template are; how many there are is the matter of
// part_list_actions.cpp.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/error.h"
#include "core/model/part_colours.h"
#include "core/session/correction_actions.h"
#include "core/session/mirror_pairs.h"
#include "core/session/template_edit.h"

namespace archetype {
namespace {

// In the order given; the partner of one that has led follows, whatever else was made of it.
void keep_all_in_step(PartTemplate& part_template, const PartList& parts) {
  std::vector<bool> led(part_template.parts.size(), false);
  for (const std::size_t part : parts) {
    if (led[part]) continue;
    keep_in_step(part_template, part);
    if (const auto partner = mirror_partner(part_template, part)) led[*partner] = true;
  }
}

void edit_each(History& history, const PartList& parts, Stage stage,
               const std::function<void(TemplatePart&)>& edit,
               const std::function<std::string(const std::string& names)>& message) {
  PartTemplate changed = active_copy(history);
  const PartList sorted = checked_parts(changed, parts);
  for (const std::size_t part : sorted) edit(changed.parts[part]);
  keep_all_in_step(changed, parts);
  const std::string text = message(names_of(changed, sorted));
  put(history, std::move(changed), stage, text);
}

}  // namespace

void rename_part(History& history, std::size_t part, const std::string& name) {
  PartTemplate changed = active_copy(history);
  const std::string message = "Rename " + part_of(changed, part).name + " to " + name;
  const std::string before = std::exchange(part_of(changed, part).name, name);
  Document document = history.committed();
  document.templates[document.active] = std::make_shared<const PartTemplate>(std::move(changed));
  // Pinned points stay with a part that another template still has by its old name.
  const bool still_there = std::ranges::any_of(document.templates, [&](const auto& each) {
    return std::ranges::find(each->parts, before, &TemplatePart::name) != each->parts.end();
  });
  if (!still_there) rename_in_corrections(document, {.part_from = before, .part_to = name});
  history.commit(std::move(document), message);
}

void set_part_label(History& history, const PartList& parts, int label, Stage stage) {
  if (label < 0) throw PreconditionError("a label is not negative");
  PartTemplate changed = active_copy(history);
  for (const std::size_t part : checked_parts(changed, parts)) changed.parts[part].label = label;
  const std::string message = "Label of " + names_of(changed, checked_parts(changed, parts));
  put(history, std::move(changed), stage, message);
}

void set_part_colour(History& history, const PartList& parts, int colour) {
  if (colour < -1 || colour >= part_colour_count) throw PreconditionError("there is no such colour");
  PartTemplate changed = active_copy(history);
  for (const std::size_t part : checked_parts(changed, parts)) changed.parts[part].colour = colour;
  const std::string message = "Colour of " + names_of(changed, checked_parts(changed, parts));
  put(history, std::move(changed), Stage::done, message);
}

void set_must_exist(History& history, const PartList& parts, bool must_exist) {
  edit_each(
      history, parts, Stage::done, [&](TemplatePart& part) { part.must_exist = must_exist; },
      [&](const std::string& names) { return names + (must_exist ? " must exist" : " may be absent"); });
}

void set_part_box(History& history, std::size_t part, const Box& box, Stage stage) {
  set_part_boxes(history, {{part, box}}, stage);
}

void set_part_boxes(History& history, const std::vector<PlacedPart>& placed, Stage stage) {
  PartTemplate changed = active_copy(history);
  PartList parts;
  bool turned = false;
  bool resized = false;
  for (const PlacedPart& each : placed) {
    TemplatePart& target = part_of(changed, each.part);
    const Box before = target.mean_box();
    set_box(target, each.box);
    turned = turned || before.orientation.angularDistance(target.orientation) > 1e-9;
    resized = resized || (before.half_extent - each.box.half_extent).norm() > 1e-12;
    parts.push_back(each.part);
  }
  keep_all_in_step(changed, parts);
  const std::string message = (turned    ? "Rotate "
                               : resized ? "Resize "
                                         : "Move ") +
                              names_of(changed, checked_parts(changed, parts));
  put(history, std::move(changed), stage, message);
}

void set_position_stddev(History& history, const PartList& parts, const Vec3& stddev, Stage stage) {
  edit_each(
      history, parts, stage,
      [&](TemplatePart& part) {
        part.position.stddev = storable(stddev, part.position.stddev, min_half_extent);
      },
      [](const std::string& names) { return "Spread of the position of " + names; });
}

void set_scale_stddev(History& history, const PartList& parts, const Vec3& stddev, Stage stage) {
  edit_each(
      history, parts, stage,
      [&](TemplatePart& part) { part.scale.stddev = storable(stddev, part.scale.stddev, min_half_extent); },
      [](const std::string& names) { return "Spread of the size of " + names; });
}

void set_existence(History& history, const PartList& parts, double existence, Stage stage) {
  edit_each(
      history, parts, stage,
      [&](TemplatePart& part) {
        if (std::isfinite(existence)) part.existence = std::clamp(existence, 0.001, 1.0);
      },
      [](const std::string& names) { return "Existence of " + names; });
}

}  // namespace archetype
