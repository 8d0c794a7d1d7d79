// Captions, legend, boxes and marks over the pictures of the clouds.
#include "ui/cloud_overlay.h"

#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/convert.h"
#include "ui/colour_legend.h"
#include "ui/studio.h"
#include "ui/viewport_overlay.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string formatted(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string number(double value) {
  return formatted("%.4f", value);
}
std::string factor(double value) {
  return formatted(value < 10 ? "%.1f" : "%.0f", value);
}
std::string short_number(double value) {
  return formatted("%g", value);
}

void draw_boxes(Studio& studio, const CloudPane& pane) {
  const CloudView& view = studio.cloud;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const TemplateRecord& record : view.content->templates)
    for (std::size_t i = 0; i < record.part_template.parts.size(); ++i) {
      const Box box = record.part_template.parts[i].mean_box();
      const Rgb rgb = part_colour(record.part_template, static_cast<int>(i));
      for (unsigned from = 0; from < 8; ++from)
        for (const unsigned side : {1U, 2U, 4U}) {
          if ((from & side) != 0) continue;
          const auto corner = [&](unsigned c) {
            const Vec3 local((c & 1U) != 0 ? 1 : -1, (c & 2U) != 0 ? 1 : -1, (c & 4U) != 0 ? 1 : -1);
            return to_screen(view.camera, pane.viewport(), to_glm(box.to_world(local)));
          };
          const auto a = corner(from);
          const auto b = corner(from | side);
          if (!a || !b) continue;
          const auto at = [&](const glm::dvec2& p) {
            return ImVec2(pane.origin.x + static_cast<float>(p.x), pane.origin.y + static_cast<float>(p.y));
          };
          draw.AddLine(at(*a), at(*b), IM_COL32(rgb[0], rgb[1], rgb[2], 190), 1.3F * studio.fonts.scale);
        }
    }
}

// A ring where a point was picked.
void draw_place(Studio& studio, const CloudPane& pane) {
  const CloudView& view = studio.cloud;
  const auto& place = studio.ui.selection.place;
  if (!place || !view.marked) return;
  const glm::vec3 wanted(to_glm(place->canonical));
  std::optional<std::size_t> nearest;
  const PointGeometry& marked = *view.marked;
  for (std::size_t i = 0; i < marked.moved.size(); ++i)
    if (!nearest || glm::distance(marked.moved[i], wanted) < glm::distance(marked.moved[*nearest], wanted))
      nearest = i;
  if (!nearest) return;
  const glm::vec3 at = glm::mix(marked.positions[*nearest], marked.moved[*nearest], pane.blend);
  const auto pixel = to_screen(view.camera, pane.viewport(), at);
  if (!pixel) return;
  const ImVec2 middle(pane.origin.x + static_cast<float>(pixel->x),
                      pane.origin.y + static_cast<float>(pixel->y));
  draw_place_ring(*ImGui::GetWindowDrawList(), middle, studio.fonts.scale);
}

// On a ground of its own: the points reach behind it.
void draw_caption(Studio& studio, const CloudPane& pane, const std::string& title, const std::string& text,
                  const std::string& more) {
  const float scale = studio.fonts.scale;
  const Palette& p = colours(studio);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 low(pane.origin.x + 12 * scale, pane.origin.y + 10 * scale);
  const float room = pane.size.x - 24 * scale;
  struct Line {
    ImFont* font;
    std::string text;
    ImU32 colour;
  };
  std::vector<Line> lines;
  float wide = 0;
  float high = 0;
  const auto add = [&](ImFont* font, const std::string& line, const ImVec4& colour) {
    if (line.empty()) return;
    ImGui::PushFont(font);
    lines.push_back({font, fitted(line, room), ImGui::GetColorU32(colour)});
    wide = std::max(wide, ImGui::CalcTextSize(lines.back().text.c_str()).x);
    high += ImGui::GetTextLineHeight() + 1 * scale;
    ImGui::PopFont();
  };
  add(studio.fonts.bold, title, p.text);
  add(ImGui::GetFont(), text, p.muted);
  add(ImGui::GetFont(), more, p.muted);
  draw.AddRectFilled({low.x - 6 * scale, low.y - 4 * scale},
                     {low.x + wide + 6 * scale, low.y + high + 3 * scale},
                     ImGui::GetColorU32(ImVec4(p.panel.x, p.panel.y, p.panel.z, 0.75F)), 4 * scale);
  float y = low.y;
  for (const Line& line : lines) {
    ImGui::PushFont(line.font);
    draw.AddText({low.x, y}, line.colour, line.text.c_str());
    y += ImGui::GetTextLineHeight() + 1 * scale;
    ImGui::PopFont();
  }
}

std::string counts(const Studio& studio) {
  const CloudContent& content = *studio.cloud.content;
  std::string text = count_text(content.shapes.size()) +
                     (content.shapes.size() == 1 ? " shape, " : " shapes, ") + count_text(content.of.size());
  text += content.samples > content.of.size() ? " of " + count_text(content.samples) + " points" : " points";
  if (studio.cloud.asked.outliers > 0)
    text += ", " + plural(studio.cloud.asked.outliers, "outlier") + " left out";
  return text;
}

void draw_captions(Studio& studio, const CloudPane& pane) {
  const Sharpness& sharpness = studio.cloud.content->sharpness;
  const double mean = sharpness.mean_at(static_cast<double>(pane.blend));
  std::string title = pane.blend <= 0 ? "Rigid" : pane.blend >= 1 ? "Deformed" : "Between rigid and deformed";
  title += "   " + number(mean);
  if (pane.blend > 0 && mean > 0) title += ", " + factor(sharpness.mean_rigid() / mean) + " times less";
  draw_caption(studio, pane, title, "mean squared distance to the canonical place",
               pane.index == 0 ? counts(studio) : "");
}

void draw_legend(Studio& studio, const CloudPane& pane) {
  const CloudContent& content = *studio.cloud.content;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 corner(pane.origin.x + pane.size.x, pane.origin.y + pane.size.y);
  if (studio.ui.cloud.colour == CloudColour::displacement) {
    const double most = content.largest_displacement;
    draw_colour_scale(draw, studio.fonts, colours(studio), corner,
                      {"Moved by the deformation", short_number(most / 2), short_number(most) + " and more"});
  }
  if (studio.ui.cloud.colour == CloudColour::part && content.templates.size() == 1) {
    const PartTemplate& part_template = content.templates.front().part_template;
    std::vector<ColourName> names;
    for (std::size_t i = 0; i < part_template.parts.size(); ++i)
      names.push_back({part_colour(part_template, static_cast<int>(i)), part_template.parts[i].name});
    draw_colour_names(draw, studio.fonts, colours(studio), corner, 0.6F * pane.size.y, names);
  }
}

}  // namespace

void draw_cloud_overlay(Studio& studio, const CloudPane& pane, bool last) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(pane.origin, {pane.origin.x + pane.size.x, pane.origin.y + pane.size.y}, true);
  if (studio.ui.cloud.boxes) draw_boxes(studio, pane);
  draw_place(studio, pane);
  draw_captions(studio, pane);
  if (last) draw_legend(studio, pane);
  const GizmoView view{studio.cloud.camera, pane.viewport(), static_cast<double>(studio.fonts.scale)};
  if (pane.index == 0) draw_axes(draw, pane.origin, view, ImGui::GetColorU32(colours(studio).text));
  draw.PopClipRect();
}

}  // namespace archetype
