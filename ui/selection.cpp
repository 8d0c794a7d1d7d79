#include "ui/selection.h"

#include <algorithm>
#include <limits>

#include "core/session/same_part.h"
#include "ui/studio.h"

namespace archetype {
namespace {

// A part that was renamed stays where it was.
std::optional<std::size_t> find_again(const PartTemplate& before, std::size_t part,
                                      const PartTemplate& after) {
  if (const auto found = find_same_part(before, part, after)) return found;
  const bool renamed = part < after.parts.size() && before.parts.size() == after.parts.size() &&
                       before.name == after.name && !find_same_part(after, part, before);
  return renamed ? std::optional(part) : std::nullopt;
}

}  // namespace

PartList selected_parts(const UiState& ui) {
  PartList parts;
  if (!ui.part) return parts;
  parts.push_back(*ui.part);
  for (const std::size_t part : ui.also_selected)
    if (part != *ui.part) parts.push_back(part);
  return parts;
}

bool is_selected(const UiState& ui, std::size_t part) {
  return ui.part && (*ui.part == part || std::find(ui.also_selected.begin(), ui.also_selected.end(), part) !=
                                             ui.also_selected.end());
}

void select_only(UiState& ui, std::optional<std::size_t> part) {
  ui.part = part;
  ui.also_selected.clear();
}

void select_all_of(UiState& ui, const PartList& parts) {
  select_only(ui, parts.empty() ? std::nullopt : std::optional(parts.front()));
  if (!parts.empty()) ui.also_selected.assign(parts.begin() + 1, parts.end());
}

void toggle_selected(UiState& ui, std::size_t part) {
  PartList parts = selected_parts(ui);
  const auto found = std::find(parts.begin(), parts.end(), part);
  if (found == parts.end())
    parts.insert(parts.begin(), part);
  else
    parts.erase(found);
  select_all_of(ui, parts);
}

void select_up_to(UiState& ui, std::size_t part) {
  if (!ui.part) return select_only(ui, part);
  const std::size_t from = *ui.part;
  PartList parts{from};
  for (std::size_t i = std::min(from, part); i <= std::max(from, part); ++i)
    if (i != from) parts.push_back(i);
  select_all_of(ui, parts);
}

void step_through_history(Studio& studio, const std::function<void(History&)>& step) {
  const PartTemplate* active = studio.history.current().active_template();
  const PartTemplate before = active ? *active : PartTemplate{};
  step(studio.history);
  const PartTemplate* after = studio.history.current().active_template();
  PartList parts;
  if (after)
    for (const std::size_t part : selected_parts(studio.ui))
      if (const auto found = find_again(before, part, *after)) parts.push_back(*found);
  select_all_of(studio.ui, parts);
}

void keep_selection_within(UiState& ui, std::size_t part_count) {
  if (ui.part && *ui.part >= part_count) ui.part.reset();
  if (!ui.part) ui.also_selected.clear();
  std::erase_if(ui.also_selected, [&](std::size_t part) { return part >= part_count || part == *ui.part; });
}

std::vector<PlacedPart> selected_boxes(const Studio& studio) {
  std::vector<PlacedPart> placed;
  const PartTemplate* active = studio.history.current().active_template();
  if (!active) return placed;
  for (const std::size_t part : selected_parts(studio.ui))
    if (part < active->parts.size()) placed.push_back({part, active->parts[part].mean_box()});
  return placed;
}

bool still_selected(const Studio& studio, const std::vector<PlacedPart>& placed) {
  const PartTemplate* active = studio.history.committed().active_template();
  const PartList parts = selected_parts(studio.ui);
  return active && std::equal(placed.begin(), placed.end(), parts.begin(), parts.end(),
                              [&](const PlacedPart& each, std::size_t part) {
                                return each.part == part && part < active->parts.size();
                              });
}

std::optional<Box> held_box(const std::vector<PlacedPart>& placed) {
  if (placed.empty()) return std::nullopt;
  if (placed.size() == 1) return placed[0].box;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const PlacedPart& each : placed) {
    const Vec3 reach = each.box.orientation.toRotationMatrix().cwiseAbs() * each.box.half_extent;
    low = low.cwiseMin(each.box.centre - reach);
    high = high.cwiseMax(each.box.centre + reach);
  }
  return Box{0.5 * (low + high), 0.5 * (high - low), Eigen::Quaterniond::Identity()};
}

std::vector<PlacedPart> carried(const std::vector<PlacedPart>& placed, const Box& from, const Box& to) {
  if (placed.size() == 1) return {{placed[0].part, to}};
  std::vector<PlacedPart> result = placed;
  if (to.half_extent == from.half_extent && to.orientation.coeffs() == from.orientation.coeffs()) {
    for (PlacedPart& each : result) each.box.centre += to.centre - from.centre;  // exact where nothing moved
    return result;
  }
  const Vec3 stretch = to.half_extent.cwiseQuotient(from.half_extent);
  const Mat3 map = to.orientation.toRotationMatrix() * stretch.asDiagonal() *
                   from.orientation.conjugate().toRotationMatrix();
  const Eigen::Quaterniond turn = to.orientation * from.orientation.conjugate();
  for (PlacedPart& each : result) {
    const Mat3 axes = map * each.box.orientation.toRotationMatrix();
    each.box.centre = to.centre + map * (each.box.centre - from.centre);
    each.box.half_extent = each.box.half_extent.cwiseProduct(axes.colwise().norm().transpose());
    each.box.orientation = (turn * each.box.orientation).normalized();
  }
  return result;
}

}  // namespace archetype
