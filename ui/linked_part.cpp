#include "ui/linked_part.h"

#include <algorithm>

#include "core/session/same_part.h"
#include "ui/selection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

// In the fitted template that the active one was, or became: that of its name; else in the first that has
// such a part.
std::optional<PartOfTemplate> explored_part(const FitTable& table, const PartTemplate& active,
                                            std::size_t part) {
  std::optional<PartOfTemplate> first;
  for (const TemplateRecord& each : table.templates) {
    const auto found = find_same_part(active, part, each.part_template);
    if (found && each.part_template.name == active.name) return PartOfTemplate{each.id, *found};
    if (found && !first) first = PartOfTemplate{each.id, *found};
  }
  return first;
}

std::optional<std::size_t> edited_part(const FitTable& table, const PartTemplate& active,
                                       const PartOfTemplate& part) {
  const auto record = std::ranges::find(table.templates, part.part_template, &TemplateRecord::id);
  return record == table.templates.end() ? std::nullopt
                                         : find_same_part(record->part_template, part.part, active);
}

}  // namespace

void link_selected_part(Studio& studio) {
  ExplorerSelection& selection = studio.ui.selection;
  const PartTemplate* active = studio.history.current().active_template();
  const bool edited = selection.linked_edited != studio.ui.part;
  const bool explored = selection.linked != selection.part;
  if (!active || (!edited && !explored)) return;
  // While boxes are edited no table of fits is read for it.
  if (edited && studio.ui.centre == CentreView::shape) return;
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!table) return;
  if (edited)
    selection.part = studio.ui.part ? explored_part(*table, *active, *studio.ui.part) : std::nullopt;
  else
    select_only(studio.ui, selection.part ? edited_part(*table, *active, *selection.part) : std::nullopt);
  selection.part_of_editor = edited;
  selection.linked = selection.part;
  selection.linked_edited = studio.ui.part;
}

}  // namespace archetype
