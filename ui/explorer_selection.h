// What is chosen while a collection is explored: one thing for grid, clouds, maps, plots and tables. Plain
// data. The shape in view is UiState::shape, whether or not it is among the selected ones.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/vector.h"
#include "core/io/project.h"

namespace archetype {

// A part of a template that shapes were fitted by; the document's templates need not hold it.
struct PartOfTemplate {
  TemplateId part_template = 0;
  std::size_t part = 0;
  friend bool operator==(const PartOfTemplate&, const PartOfTemplate&) = default;
};

// A place that was pointed at on one shape, so that it can be shown on all of its cluster.
struct PickedPlace {
  PartOfTemplate on;
  Vec3 canonical = Vec3::Zero();  // in the template's frame, on or near the mean box of the part
  ShapeId shape = 0;              // where it was picked
};

struct ExplorerSelection {
  std::vector<ShapeId> shapes;  // ascending, each once
  // Under the mouse, in whichever panel: a panel sets `hovering` in this frame, and all see it as `hovered`
  // in the next one.
  std::optional<ShapeId> hovering;
  std::optional<ShapeId> hovered;
  std::optional<PartOfTemplate> part;
  std::optional<PickedPlace> place;
  std::uint64_t revision = 0;  // changes with `shapes`
  // `part` and the editor's part when they were brought in line last: see linked_part.h.
  std::optional<PartOfTemplate> linked;
  std::optional<std::size_t> linked_edited;
  bool part_of_editor = false;  // `part` came of the editor's, not the other way round
};

bool is_selected(const ExplorerSelection& selection, ShapeId shape);
// All others are let go.
void select_only(ExplorerSelection& selection, std::vector<ShapeId> shapes);
void add_to_selection(ExplorerSelection& selection, const std::vector<ShapeId>& shapes);
void toggle_selected(ExplorerSelection& selection, ShapeId shape);

}  // namespace archetype
