#include <cstdio>
#include <string>

#include "core/session/cluster_size.h"
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

std::vector<ClusterSize> sizes_of(const MadeMap& made) {
  std::vector<ClusterSize> sizes(made.table->templates.size());
  for (const MapPoint& point : made.map.points)
    sizes[point.part_template].add(point.outlier ? FitStatus::outlier : FitStatus::fitted);
  return sizes;
}

void select_members(Studio& studio, const MadeMap& made, std::size_t part_template) {
  std::vector<ShapeId> members;
  for (const MapPoint& point : made.map.points)
    if (point.part_template == part_template) members.push_back(point.shape);
  select_only(studio.ui.selection, std::move(members));
}

// A dot and a text, which can be clicked.
void draw_entry(Studio& studio, const MadeMap& made, std::size_t part_template, const std::string& text,
                ImVec2 low, float width) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const float line = ImGui::GetTextLineHeight();
  ImGui::SetCursorScreenPos(low);
  ImGui::PushID(static_cast<int>(part_template));
  const bool clicked = ImGui::InvisibleButton("legend", {width, line});
  ImGui::PopID();
  mark_target(studio, "map:template:" + std::to_string(part_template));
  tooltip("Select the shapes of this template");
  const bool hovered = ImGui::IsItemHovered();
  if (clicked) select_members(studio, made, part_template);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled({low.x + 6 * scale, low.y + line / 2}, 5 * scale, map_colour(part_template));
  draw.AddText({low.x + 16 * scale, low.y}, ImGui::GetColorU32(hovered ? p.accent : p.text), text.c_str());
}

}  // namespace

float draw_map_legend(Studio& studio, const MadeMap& made, ImVec2 low, float width, float height) {
  const float scale = studio.fonts.scale;
  const float step = 1.3f * ImGui::GetTextLineHeight();
  const float left = low.x + 10 * scale;
  const float right = low.x + width - 10 * scale;
  const float room_for_rest = ImGui::CalcTextSize("and 100 more").x;
  ImVec2 at(left, low.y + 6 * scale);
  const std::vector<ClusterSize> sizes = sizes_of(made);
  std::size_t left_out = 0;
  for (std::size_t t = 0; t < sizes.size(); ++t) {
    if (sizes[t] == ClusterSize{}) continue;
    const std::string name = fitted(made.table->templates[t].part_template.name, 0.4f * width);
    const std::string text = name + "  ·  " + to_string(sizes[t]);
    const float wide = ImGui::CalcTextSize(text.c_str()).x + 20 * scale;
    const bool last_line = at.y + 2 * step > low.y + height / 3;
    const bool fits = at.x + wide <= right - (last_line ? room_for_rest : 0) || at.x == left;
    if (left_out > 0 || (!fits && last_line)) {
      ++left_out;
      continue;
    }
    if (!fits) at = {left, at.y + step};
    draw_entry(studio, made, t, text, at, wide);
    at.x += wide + 12 * scale;
  }
  if (left_out > 0)
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(colours(studio).muted),
                                        ("and " + std::to_string(left_out) + " more").c_str());
  return at.y + step - low.y;
}

float axes_height(const MadeMap& made) {
  const float line = 1.2f * ImGui::GetTextLineHeight();
  float height = 0;
  for (const MapAxis& axis : made.map.axes) height += axis.share > 0 ? line : 0;
  return height > 0 ? height + 0.4f * line : 0;
}

void draw_map_axes(Studio& studio, const MadeMap& made, ImVec2 low, float width) {
  const float scale = studio.fonts.scale;
  const float room = width - 20 * scale;
  ImVec2 at(low.x + 10 * scale, low.y + 0.2f * ImGui::GetTextLineHeight());
  const std::pair<const char*, const MapAxis&> axes[] = {{"Up: ", made.map.axes[1]},
                                                         {"Across: ", made.map.axes[0]}};
  for (const auto& [direction, axis] : axes) {
    if (!(axis.share > 0)) continue;
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(colours(studio).muted),
                                        fitted(axis_text(direction, axis), room).c_str());
    at.y += 1.2f * ImGui::GetTextLineHeight();
  }
}

}  // namespace archetype
