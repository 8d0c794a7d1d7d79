#include "core/session/template_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/sort_unique.h"
#include "core/io/template_file.h"

namespace archetype {
namespace {

bool has_part(const PartTemplate& part_template, const std::string& name) {
  return std::any_of(part_template.parts.begin(), part_template.parts.end(),
                     [&](const TemplatePart& part) { return part.name == name; });
}

Eigen::Quaterniond storable(const Eigen::Quaterniond& wanted, const Eigen::Quaterniond& before) {
  const double norm = wanted.norm();
  return std::isfinite(norm) && norm > 0 ? wanted.normalized() : before;
}

}  // namespace

PartTemplate active_copy(const History& history) {
  const PartTemplate* active = history.committed().active_template();
  if (!active) throw PreconditionError("there is no active template");
  return *active;
}

TemplatePart& part_of(PartTemplate& part_template, std::size_t part) {
  if (part >= part_template.parts.size()) throw PreconditionError("there is no such part");
  return part_template.parts[part];
}

PartList checked_parts(const PartTemplate& part_template, PartList parts) {
  sort_unique(parts);
  if (parts.empty()) throw PreconditionError("there is no part to edit");
  if (parts.back() >= part_template.parts.size()) throw PreconditionError("there is no such part");
  return parts;
}

std::string names_of(const PartTemplate& part_template, const PartList& parts) {
  return parts.size() == 1 ? part_template.parts[parts[0]].name : std::to_string(parts.size()) + " parts";
}

void put(History& history, PartTemplate part_template, Stage stage, const std::string& message) {
  Document document = history.committed();
  document.templates[document.active] = std::make_shared<const PartTemplate>(std::move(part_template));
  if (stage == Stage::live)
    history.preview(std::move(document));
  else
    history.commit(std::move(document), message);
}

Vec3 storable(const Vec3& wanted, const Vec3& before, double least) {
  if (!wanted.allFinite()) return before;
  return wanted.cwiseMax(least).cwiseMin(largest_template_value);
}

void set_box(TemplatePart& part, const Box& box) {
  part.position.mean = storable(box.centre, part.position.mean, -largest_template_value);
  part.scale.mean = storable(box.half_extent, part.scale.mean, min_half_extent);
  part.orientation = storable(box.orientation, part.orientation);
}

void expect_room(const PartTemplate& part_template, std::size_t more) {
  if (part_template.parts.size() + more > most_template_parts)
    throw Error("a template has at most " + std::to_string(most_template_parts) + " parts");
}

std::string free_part_name(const PartTemplate& part_template, const std::string& name) {
  if (!has_part(part_template, name)) return name;
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

}  // namespace archetype
