#include "ui/part_highlight.h"

#include <algorithm>

#include "core/session/same_part.h"
#include "ui/studio.h"

namespace archetype {

std::optional<std::size_t> highlighted_part(Studio& studio, const PartTemplate& part_template) {
  const std::optional<PartOfTemplate>& selected = studio.ui.selection.part;
  if (!selected) return std::nullopt;
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!table) return std::nullopt;
  const auto of = std::ranges::find(table->templates, selected->part_template, &TemplateRecord::id);
  if (of == table->templates.end()) return std::nullopt;
  return find_same_part(of->part_template, selected->part, part_template);
}

bool highlights_in_shape_view(const Studio& studio) {
  const ExplorerSelection& selection = studio.ui.selection;
  return selection.part && !selection.part_of_editor && selection.linked_edited == studio.ui.part;
}

std::optional<int> highlighted_in_view(Studio& studio, const ViewFit& fit) {
  if (!highlights_in_shape_view(studio) || !fit.part_template) return std::nullopt;
  if (!use_fit_table(studio)) return std::nullopt;
  const auto part = highlighted_part(studio, *fit.part_template);
  return part ? static_cast<int>(*part) : no_such_part;
}

void select_part_of(Studio& studio, const TemplateRecord& record, std::optional<std::size_t> part) {
  std::optional<PartOfTemplate>& selected = studio.ui.selection.part;
  if (!part || highlighted_part(studio, record.part_template) == part)
    selected.reset();
  else
    selected = PartOfTemplate{record.id, *part};
}

}  // namespace archetype
