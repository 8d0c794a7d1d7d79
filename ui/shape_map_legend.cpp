#include <cstdio>

#include "ui/shape_map_paint.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string axis_text(const char* direction, const MapAxis& axis) {
  char share[32];
  std::snprintf(share, sizeof share, "  (%.0f %%)", 100 * axis.share);
  return std::string(direction) + axis.meaning + share;
}

// On ground that leaves it readable over whatever lies below.
void draw_caption(Studio& studio, ImVec2 low, const std::string& text, const ImVec4& colour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float scale = studio.fonts.scale;
  ImVec4 ground = colours(studio).panel;
  ground.w = 0.8f;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw.AddRectFilled({low.x - 4 * scale, low.y - scale}, {low.x + size.x + 4 * scale, low.y + size.y + scale},
                     ImGui::GetColorU32(ground), 3 * scale);
  draw.AddText(low, ImGui::GetColorU32(colour), text.c_str());
}

}  // namespace

std::vector<LegendLine> follow_map_legend(Studio& studio, const MadeMap& made, const MapSpace& space) {
  const float scale = studio.fonts.scale;
  const float line = ImGui::GetTextLineHeight();
  std::vector<std::size_t> counts(made.table->templates.size());
  for (const MapPoint& point : made.map.points) ++counts[point.part_template];
  std::vector<LegendLine> legend;
  float y = space.low.y + 8 * scale;
  for (std::size_t t = 0; t < counts.size() && y + line < space.high.y - 3 * line; ++t) {
    if (counts[t] == 0) continue;
    const std::string name = fitted(made.table->templates[t].part_template.name, 0.35f * space.size().x);
    LegendLine entry{t, name + "  ·  " + count_text(counts[t]), {space.low.x + 10 * scale, y}, false};
    ImGui::SetCursorScreenPos(entry.low);
    ImGui::PushID(static_cast<int>(t));
    const float width = ImGui::CalcTextSize(entry.text.c_str()).x + 22 * scale;
    const bool clicked = ImGui::InvisibleButton("legend", {width, line});
    ImGui::PopID();
    mark_target(studio, "map:template:" + std::to_string(t));
    tooltip("Select the shapes of this template");
    entry.hovered = ImGui::IsItemHovered();
    if (clicked) {
      std::vector<ShapeId> members;
      for (const MapPoint& point : made.map.points)
        if (point.part_template == t) members.push_back(point.shape);
      select_only(studio.ui.selection, std::move(members));
    }
    legend.push_back(std::move(entry));
    y += 1.35f * line;
  }
  return legend;
}

void draw_map_captions(Studio& studio, const MadeMap& made, const MapSpace& space,
                       const std::vector<LegendLine>& legend) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const float line = ImGui::GetTextLineHeight();
  for (const LegendLine& entry : legend) {
    draw_caption(studio, {entry.low.x + 18 * scale, entry.low.y}, entry.text,
                 entry.hovered ? p.accent : p.text);
    ImGui::GetWindowDrawList()->AddCircleFilled({entry.low.x + 6 * scale, entry.low.y + line / 2}, 5 * scale,
                                                map_colour(entry.part_template));
  }
  const float room = space.size().x - 24 * scale;
  const ImVec2 corner(space.low.x + 12 * scale, space.high.y - line - 8 * scale);
  if (made.map.axes[0].share > 0)
    draw_caption(studio, corner, fitted(axis_text("Across: ", made.map.axes[0]), room), p.muted);
  if (made.map.axes[1].share > 0)
    draw_caption(studio, {corner.x, corner.y - 1.2f * line},
                 fitted(axis_text("Up: ", made.map.axes[1]), room), p.muted);
}

}  // namespace archetype
