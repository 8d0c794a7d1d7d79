#include "ui/plot_selection.h"

#include <algorithm>

#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::size_t selected_among(const Studio& studio, std::span<const ShapeId> shapes) {
  if (studio.ui.selection.shapes.empty()) return 0;
  return static_cast<std::size_t>(
      std::ranges::count_if(shapes, [&](ShapeId id) { return is_selected(studio.ui.selection, id); }));
}

// The part of a category; nothing where categories are no parts.
const NamedPart* part_of(const Figure& figure, const HoverValue& value) {
  const Plot& plot = figure.panels[value.panel];
  if (plot.parts.empty() || value.series >= plot.series.size()) return nullptr;
  const PlotSeries& series = plot.series[value.series];
  if (value.point >= series.x.size()) return nullptr;
  const auto category = static_cast<std::size_t>(series.x[value.point]);
  return category < plot.parts.size() ? &plot.parts[category] : nullptr;
}

void pick_part(Studio& studio, const NamedPart& named) {
  const std::shared_ptr<const FitTable> table = use_fit_table(studio);
  if (!table) return;
  for (const TemplateRecord& record : table->templates) {
    if (record.part_template.name != named.part_template) continue;
    const auto& parts = record.part_template.parts;
    const auto found = std::ranges::find(parts, named.part, &TemplatePart::name);
    if (found == parts.end()) continue;
    studio.ui.selection.part = PartOfTemplate{record.id, static_cast<std::size_t>(found - parts.begin())};
    studio.ui.selection.place.reset();
    return;
  }
}

}  // namespace

std::span<const ShapeId> shapes_of(const Figure& figure, const HoverValue& value) {
  const Plot& plot = figure.panels[value.panel];
  if (plot.matrix || value.series >= plot.series.size()) return {};
  const auto& shapes = plot.series[value.series].shapes;
  if (value.point >= shapes.size()) return {};
  return shapes[value.point];
}

void select_value(Studio& studio, const Figure& figure, const HoverValue& value, bool add) {
  if (const NamedPart* part = part_of(figure, value)) pick_part(studio, *part);
  const std::span<const ShapeId> shapes = shapes_of(figure, value);
  if (shapes.empty()) return;
  if (add)
    add_to_selection(studio.ui.selection, {shapes.begin(), shapes.end()});
  else
    select_only(studio.ui.selection, {shapes.begin(), shapes.end()});
  if (!add && shapes.size() == 1) show_shape(studio, shapes.front());
  studio.ui.grid.scroll_to_shape = true;
  say(studio, Severity::note, plural(studio.ui.selection.shapes.size(), "shape") + " selected");
}

std::string selection_hint(const Studio& studio, const Figure& figure, const HoverValue& value) {
  const std::span<const ShapeId> shapes = shapes_of(figure, value);
  if (shapes.empty()) return part_of(figure, value) ? "Click to see the part in all views" : "";
  const std::size_t selected = selected_among(studio, shapes);
  std::string text = selected > 0 ? count_text(selected) + " of them selected. " : "";
  return text + (shapes.size() == 1 ? "Click to select the shape" : "Click to select these shapes");
}

void draw_selected_shares(const Studio& studio, const Figure& figure, const PlotDrawing& drawing,
                          ImVec2 origin) {
  const ExplorerSelection& selection = studio.ui.selection;
  const std::optional<ShapeId> pointed = selection.hovered ? selection.hovered : studio.ui.shape;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  for (const HoverValue& value : drawing.values) {
    const std::span<const ShapeId> shapes = shapes_of(figure, value);
    if (!value.bar || shapes.empty()) continue;
    ImVec2 low(origin.x + value.bar->low.x, origin.y + value.bar->low.y);
    ImVec2 high(origin.x + value.bar->high.x, origin.y + value.bar->high.y);
    if (pointed && std::ranges::find(shapes, *pointed) != shapes.end())
      draw.AddRect(low, high, ImGui::GetColorU32(selection.hovered ? p.warning : p.text), 0, 0, 1.5f * scale);
    const std::size_t selected = selected_among(studio, shapes);
    if (selected == 0) continue;
    const float share = static_cast<float>(selected) / static_cast<float>(shapes.size());
    if (value.bar->upright)
      low.y = high.y - std::max(share * (high.y - low.y), 2 * scale);
    else
      high.x = low.x + std::max(share * (high.x - low.x), 2 * scale);
    draw.AddRectFilled(low, high, ImGui::GetColorU32({p.accent.x, p.accent.y, p.accent.z, 0.8f}));
    draw.AddRect(low, high, ImGui::GetColorU32(p.text), 0, 0, scale);
  }
}

}  // namespace archetype
