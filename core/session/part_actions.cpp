// Edits of the parts of the active template.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/actions.h"

namespace archetype {
namespace {

// The active template of the committed document, to be changed and handed back.
PartTemplate active_copy(const History& history) {
  const PartTemplate* active = history.committed().active_template();
  if (!active) throw PreconditionError("there is no active template");
  return *active;
}

TemplatePart& part_of(PartTemplate& part_template, std::size_t part) {
  if (part >= part_template.parts.size()) throw PreconditionError("there is no such part");
  return part_template.parts[part];
}

void put(History& history, PartTemplate part_template, Stage stage, const std::string& message) {
  Document document = history.committed();
  document.templates[document.active] = std::make_shared<const PartTemplate>(std::move(part_template));
  if (stage == Stage::live)
    history.preview(std::move(document));
  else
    history.commit(std::move(document), message);
}

// What a template file can hold of the numbers that are wanted.
Vec3 storable(const Vec3& wanted, const Vec3& before, double least) {
  if (!wanted.allFinite()) return before;
  return wanted.cwiseMax(least).cwiseMin(largest_template_value);
}

Vec3 storable_place(const Vec3& wanted, const Vec3& before) {
  return storable(wanted, before, -largest_template_value);
}

Eigen::Quaterniond storable(const Eigen::Quaterniond& wanted, const Eigen::Quaterniond& before) {
  const double norm = wanted.norm();
  return std::isfinite(norm) && norm > 0 ? wanted.normalized() : before;
}

void expect_room(const PartTemplate& part_template) {
  if (part_template.parts.size() >= most_template_parts)
    throw Error("a template has at most " + std::to_string(most_template_parts) + " parts");
}

bool has_part(const PartTemplate& part_template, const std::string& name) {
  return std::any_of(part_template.parts.begin(), part_template.parts.end(),
                     [&](const TemplatePart& part) { return part.name == name; });
}

// "leg 2" for "leg", "leg 3" for "leg 2": the first number that is free.
std::string numbered_name(const PartTemplate& part_template, const std::string& name) {
  std::string stem = name;
  const std::size_t space = stem.find_last_of(' ');
  if (space != std::string::npos && space + 1 < stem.size() &&
      stem.find_first_not_of("0123456789", space + 1) == std::string::npos)
    stem.resize(space);
  std::string candidate;
  for (int number = 2; candidate.empty() || has_part(part_template, candidate); ++number)
    candidate = stem + " " + std::to_string(number);
  return candidate;
}

std::size_t insert_copy(History& history, PartTemplate part_template, TemplatePart copy, std::size_t after,
                        const std::string& message) {
  expect_room(part_template);
  copy.name = numbered_name(part_template, copy.name);
  part_template.parts.insert(part_template.parts.begin() + static_cast<std::ptrdiff_t>(after) + 1,
                             std::move(copy));
  put(history, std::move(part_template), Stage::done, message);
  return after + 1;
}

}  // namespace

std::size_t add_part(History& history, const Box& box) {
  PartTemplate changed = active_copy(history);
  expect_room(changed);
  TemplatePart part;
  part.name = has_part(changed, "part") ? numbered_name(changed, "part") : "part";
  for (const TemplatePart& other : changed.parts)
    if (other.label < std::numeric_limits<int>::max()) part.label = std::max(part.label, other.label + 1);
  part.position.mean = storable_place(box.centre, part.position.mean);
  part.scale.mean = storable(box.half_extent, part.scale.mean, min_half_extent);
  part.orientation = storable(box.orientation, part.orientation);
  const std::string message = "Add " + part.name;
  changed.parts.push_back(std::move(part));
  const std::size_t index = changed.parts.size() - 1;
  put(history, std::move(changed), Stage::done, message);
  return index;
}

std::size_t duplicate_part(History& history, std::size_t part) {
  PartTemplate changed = active_copy(history);
  TemplatePart copy = part_of(changed, part);
  const std::string message = "Duplicate " + copy.name;
  // Beside the original, where it can be seen and taken.
  copy.position.mean =
      storable_place(copy.position.mean + Vec3(2 * copy.scale.mean.x(), 0, 0), copy.position.mean);
  return insert_copy(history, std::move(changed), std::move(copy), part, message);
}

std::size_t mirror_part(History& history, std::size_t part) {
  PartTemplate changed = active_copy(history);
  TemplatePart copy = part_of(changed, part);
  const std::string message = "Mirror " + copy.name;
  copy.position.mean.x() = -copy.position.mean.x();
  // A box is symmetric about its own axes, so the mirror image of the rotation (w, x, y, z) at x = 0 is
  // (w, x, -y, -z): axial vectors keep their component along the normal of the mirror.
  copy.orientation.y() = -copy.orientation.y();
  copy.orientation.z() = -copy.orientation.z();
  return insert_copy(history, std::move(changed), std::move(copy), part, message);
}

void remove_part(History& history, std::size_t part) {
  PartTemplate changed = active_copy(history);
  const std::string message = "Delete " + part_of(changed, part).name;
  changed.parts.erase(changed.parts.begin() + static_cast<std::ptrdiff_t>(part));
  put(history, std::move(changed), Stage::done, message);
}

void rename_part(History& history, std::size_t part, const std::string& name) {
  PartTemplate changed = active_copy(history);
  const std::string message = "Rename " + part_of(changed, part).name + " to " + name;
  part_of(changed, part).name = name;
  put(history, std::move(changed), Stage::done, message);
}

void set_part_label(History& history, std::size_t part, int label, Stage stage) {
  PartTemplate changed = active_copy(history);
  if (label < 0) throw PreconditionError("a label is not negative");
  part_of(changed, part).label = label;
  const std::string message = "Label of " + changed.parts[part].name;
  put(history, std::move(changed), stage, message);
}

void set_must_exist(History& history, std::size_t part, bool must_exist) {
  PartTemplate changed = active_copy(history);
  TemplatePart& target = part_of(changed, part);
  target.must_exist = must_exist;
  const std::string message = target.name + (must_exist ? " must exist" : " may be absent");
  put(history, std::move(changed), Stage::done, message);
}

void set_part_box(History& history, std::size_t part, const Box& box, Stage stage) {
  PartTemplate changed = active_copy(history);
  TemplatePart& target = part_of(changed, part);
  const Box before = target.mean_box();
  target.position.mean = storable_place(box.centre, before.centre);
  target.scale.mean = storable(box.half_extent, before.half_extent, min_half_extent);
  target.orientation = storable(box.orientation, before.orientation);
  const bool turned = before.orientation.angularDistance(target.orientation) > 1e-9;
  const bool resized = (before.half_extent - box.half_extent).norm() > 1e-12;
  const std::string message = (turned ? "Rotate " : resized ? "Resize " : "Move ") + target.name;
  put(history, std::move(changed), stage, message);
}

void set_position_stddev(History& history, std::size_t part, const Vec3& stddev, Stage stage) {
  PartTemplate changed = active_copy(history);
  Vec3& target = part_of(changed, part).position.stddev;
  target = storable(stddev, target, min_half_extent);
  const std::string message = "Spread of the position of " + changed.parts[part].name;
  put(history, std::move(changed), stage, message);
}

void set_scale_stddev(History& history, std::size_t part, const Vec3& stddev, Stage stage) {
  PartTemplate changed = active_copy(history);
  Vec3& target = part_of(changed, part).scale.stddev;
  target = storable(stddev, target, min_half_extent);
  const std::string message = "Spread of the size of " + changed.parts[part].name;
  put(history, std::move(changed), stage, message);
}

void set_existence(History& history, std::size_t part, double existence, Stage stage) {
  PartTemplate changed = active_copy(history);
  TemplatePart& target = part_of(changed, part);
  if (std::isfinite(existence)) target.existence = std::clamp(existence, 0.001, 1.0);
  const std::string message = "Existence of " + changed.parts[part].name;
  put(history, std::move(changed), stage, message);
}

}  // namespace archetype
