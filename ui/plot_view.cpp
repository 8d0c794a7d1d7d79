#include "ui/plot_view.h"

#include <cmath>

#include "core/report/plot_drawing.h"
#include "ui/plot_selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

ImU32 colour_of(const Palette& p, Ink ink, const Rgb& colour, float opacity = 1) {
  switch (ink) {
    case Ink::text:
      return ImGui::GetColorU32(p.text);
    case Ink::muted:
      return ImGui::GetColorU32(p.muted);
    case Ink::grid:
      return ImGui::GetColorU32({p.muted.x, p.muted.y, p.muted.z, 0.22f});
    case Ink::data:
      break;
  }
  return IM_COL32(colour[0], colour[1], colour[2], static_cast<int>(255 * opacity));
}

// Dark series are for white paper: on dark ground they are lifted.
Rgb on_ground(const Studio& studio, Rgb colour) {
  if (studio.theme != Theme::dark || colour[0] + colour[1] + colour[2] > 240) return colour;
  for (std::uint8_t& channel : colour) channel = static_cast<std::uint8_t>(channel + (235 - channel) * 3 / 5);
  return colour;
}

struct Painter {
  Studio& studio;
  ImDrawList& draw;
  ImVec2 origin;
  const Palette& p;

  ImVec2 at(PlotPoint point) const { return {origin.x + point.x, origin.y + point.y}; }

  void operator()(const DrawnLine& line) const {
    const ImU32 colour = colour_of(p, line.ink, on_ground(studio, line.colour));
    if (line.dashed) {
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        dash(line.points[i], line.points[i + 1], i, colour, line.width);
      return;
    }
    std::vector<ImVec2> points;
    for (const PlotPoint& point : line.points) points.push_back(at(point));
    draw.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, line.width);
  }
  void operator()(const DrawnArea& area) const {
    const Rgb colour = area.of_scale ? area.colour : on_ground(studio, area.colour);
    draw.AddRectFilled(at(area.low), at(area.high), colour_of(p, Ink::data, colour, area.opacity));
  }
  void operator()(const DrawnSpot& spot) const {
    draw.AddCircleFilled(at(spot.at), spot.radius, colour_of(p, Ink::data, on_ground(studio, spot.colour)));
  }
  void operator()(const DrawnText& text) const {
    ImFont* font = text.kind == TextKind::title ? studio.fonts.bold : ImGui::GetFont();
    const float size = font == ImGui::GetFont() ? ImGui::GetFontSize() : font->FontSize;
    const float width = font->CalcTextSizeA(size, 1e9f, 0, text.text.c_str()).x;
    const ImVec2 low = at(text.at);
    draw.AddText(font, size, {std::round(low.x - text.anchor * width), std::round(low.y)},
                 colour_of(p, text.ink, text.colour), text.text.c_str());
  }

 private:
  // Dashes of 6 and gaps of 4, along each piece of the line: short pieces are drawn every other one.
  void dash(PlotPoint a, PlotPoint b, std::size_t piece, ImU32 colour, float width) const {
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const float scale = studio.fonts.scale;
    if (length < 10 * scale) {
      if (piece % 2 == 0) draw.AddLine(at(a), at(b), colour, width);
      return;
    }
    const int dashes = static_cast<int>(std::ceil(length / (10 * scale)));
    for (int i = 0; i < dashes; ++i) {
      const float from = static_cast<float>(i) * 10 * scale;
      const float to = std::min(from + 6 * scale, length);
      const auto along = [&](float t) {
        return PlotPoint{a.x + (b.x - a.x) * t / length, a.y + (b.y - a.y) * t / length};
      };
      draw.AddLine(at(along(from)), at(along(to)), colour, width);
    }
  }
};

}  // namespace

void draw_plot_view(Studio& studio, const Figure& figure, ImVec2 size) {
  ImGui::BeginChild("##plot-view", size);
  PlotSpace space;
  const float bar = ImGui::GetStyle().ScrollbarSize;
  space.width = std::max(40.0f, ImGui::GetContentRegionAvail().x - bar);
  space.height = std::max(40.0f, ImGui::GetContentRegionAvail().y - 4 * studio.fonts.scale);
  space.line = ImGui::GetTextLineHeight();
  space.scale = studio.fonts.scale;
  space.text_width = [&](const std::string& text, TextKind kind) {
    ImFont* font = kind == TextKind::title ? studio.fonts.bold : ImGui::GetFont();
    const float height = font == ImGui::GetFont() ? ImGui::GetFontSize() : font->FontSize;
    return font->CalcTextSizeA(height, 1e9f, 0, text.c_str()).x;
  };
  const PlotDrawing drawing = draw_figure(figure, space);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##plot", {drawing.width, std::max(1.0f, drawing.height)});
  mark_target(studio, "plot");
  const Painter painter{studio, *ImGui::GetWindowDrawList(), origin, colours(studio)};
  for (const DrawnMark& mark : drawing.marks) std::visit(painter, mark);
  draw_selected_shares(studio, figure, drawing, origin);
  for (const HoverValue& value : drawing.values)
    if (value.bar)
      studio.targets.push_back({"bar:" + std::to_string(value.panel) + ":" + std::to_string(value.series) +
                                    ":" + std::to_string(value.point),
                                origin.x + value.bar->low.x, origin.y + value.bar->low.y,
                                origin.x + value.bar->high.x, origin.y + value.bar->high.y});
  if (ImGui::IsItemHovered()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (const auto value = value_at(drawing, mouse.x - origin.x, mouse.y - origin.y)) {
      const HoverValue& hovered = drawing.values[*value];
      painter.draw.AddRect(painter.at(hovered.low), painter.at(hovered.high),
                           ImGui::GetColorU32(colours(studio).accent), 2 * studio.fonts.scale);
      const std::string hint = selection_hint(studio, figure, hovered);
      ImGui::SetTooltip("%s%s%s", hovered.text.c_str(), hint.empty() ? "" : "\n", hint.c_str());
      if (clicked) select_value(studio, figure, hovered, ImGui::GetIO().KeyCtrl);
    }
  }
  ImGui::EndChild();
}

}  // namespace archetype
