#include "ui/explorer_selection.h"

#include <algorithm>

#include "core/base/sort_unique.h"

namespace archetype {

bool is_selected(const ExplorerSelection& selection, ShapeId shape) {
  return std::ranges::binary_search(selection.shapes, shape);
}

void select_only(ExplorerSelection& selection, std::vector<ShapeId> shapes) {
  sort_unique(shapes);
  if (shapes == selection.shapes) return;
  selection.shapes = std::move(shapes);
  ++selection.revision;
}

void add_to_selection(ExplorerSelection& selection, const std::vector<ShapeId>& shapes) {
  std::vector<ShapeId> all = selection.shapes;
  all.insert(all.end(), shapes.begin(), shapes.end());
  select_only(selection, std::move(all));
}

void toggle_selected(ExplorerSelection& selection, ShapeId shape) {
  const auto at = std::ranges::lower_bound(selection.shapes, shape);
  if (at != selection.shapes.end() && *at == shape)
    selection.shapes.erase(at);
  else
    selection.shapes.insert(at, shape);
  ++selection.revision;
}

}  // namespace archetype
