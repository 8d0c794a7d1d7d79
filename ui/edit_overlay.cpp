#include "ui/edit_overlay.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "render/convert.h"

namespace archetype {
namespace {

constexpr ImU32 snap_colour = IM_COL32(255, 88, 200, 255);
constexpr ImU32 plate = IM_COL32(24, 26, 30, 225);
constexpr ImU32 white = IM_COL32(255, 255, 255, 255);
constexpr ImU32 muted = IM_COL32(178, 184, 192, 255);

ImVec2 at(ImVec2 origin, const glm::dvec2& pixel) {
  return {origin.x + static_cast<float>(pixel.x), origin.y + static_cast<float>(pixel.y)};
}

void draw_tag(ImDrawList& draw, ImVec2 place, const std::string& text, float scale) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw.AddRectFilled(place, {place.x + size.x + 12 * scale, place.y + size.y + 5 * scale}, plate, 4 * scale);
  draw.AddText({place.x + 6 * scale, place.y + 2.5F * scale}, snap_colour, text.c_str());
}

// The plane as a rectangle somewhat larger than the box.
std::array<Vec3, 4> outline(const SnapPlane& plane, const Box& box) {
  const Vec3 room = box.orientation.toRotationMatrix().cwiseAbs() * box.half_extent;
  const double margin = 0.25 * room.maxCoeff();
  const int u = (plane.axis + 1) % 3;
  const int v = (plane.axis + 2) % 3;
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = box.centre;
    corners[i][plane.axis] = plane.at;
    corners[i][u] += (i == 0 || i == 3 ? -1 : 1) * (room[u] + margin);
    corners[i][v] += (i < 2 ? -1 : 1) * (room[v] + margin);
  }
  return corners;
}

}  // namespace

void draw_axis_line(ImDrawList& draw, ImVec2 origin, const Vec3& place, const Vec3& direction, int axis,
                    const GizmoView& view) {
  const double reach = 4 * view.camera.distance;
  // Behind the eye there is no pixel: as far as can be seen.
  const auto end = [&](double sign) {
    double length = reach;
    auto pixel = to_screen(view.camera, view.viewport, to_glm(Vec3(place + sign * length * direction)));
    while (!pixel && length > 0.01 * reach) {
      length *= 0.8;
      pixel = to_screen(view.camera, view.viewport, to_glm(Vec3(place + sign * length * direction)));
    }
    return pixel;
  };
  const auto from = end(-1);
  const auto to = end(1);
  if (!from || !to) return;
  draw.AddLine(at(origin, *from), at(origin, *to), axis_colour(axis), 1.5F * static_cast<float>(view.scale));
}

void draw_snapped(ImDrawList& draw, ImVec2 origin, const Snapped& snapped, const GizmoView& view) {
  const auto scale = static_cast<float>(view.scale);
  const auto middle = to_screen(view.camera, view.viewport, to_glm(snapped.box.centre));
  if (!middle) return;
  ImVec2 tag = at(origin, *middle);
  tag.x += 26 * scale;
  tag.y += 26 * scale;
  const auto write = [&](const std::string& text) {
    draw_tag(draw, tag, text, scale);
    tag.y += ImGui::GetTextLineHeight() + 7 * scale;
  };
  for (const SnapPlane& plane : snapped.planes) {
    std::array<ImVec2, 4> points;
    bool seen = true;
    const std::array<Vec3, 4> corners = outline(plane, snapped.box);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto pixel = to_screen(view.camera, view.viewport, to_glm(corners[i]));
      seen = seen && pixel;
      if (pixel) points[i] = at(origin, *pixel);
    }
    if (seen) {
      draw.AddConvexPolyFilled(points.data(), 4, (snap_colour & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 28));
      draw.AddPolyline(points.data(), 4, snap_colour, ImDrawFlags_Closed, 1.5F * scale);
    }
    write(plane.name);
  }
  if (snapped.turned_degrees) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f°", *snapped.turned_degrees);
    write(text);
  }
}

ScreenRect strip_place(ImVec2 origin, const GizmoView& view, const ScreenRect& taken, ImVec2 text_size) {
  const auto scale = static_cast<float>(view.scale);
  const ImVec2 size{text_size.x + 24 * scale, text_size.y + 12 * scale};
  const float middle = origin.x + 0.5F * (static_cast<float>(view.viewport.width) - size.x);
  const float x = std::max(std::min(middle, taken.low.x - 6 * scale - size.x), origin.x + 6 * scale);
  const float y = origin.y + 10 * scale;
  return {{x, y}, {x + size.x, y + size.y}};
}

void draw_strip(ImDrawList& draw, ImVec2 origin, const GizmoView& view, const ScreenRect& taken,
                const std::string& text, const std::string& hint) {
  const auto scale = static_cast<float>(view.scale);
  const ImVec2 text_size = ImGui::CalcTextSize(text.c_str());
  const float gap = 22 * scale;
  const float wide = text_size.x + gap + ImGui::CalcTextSize(hint.c_str()).x;
  // The hint goes where there is no room for both.
  const bool both = wide + 36 * scale < taken.low.x - origin.x;
  const auto [low, high] = strip_place(origin, view, taken, {both ? wide : text_size.x, text_size.y});
  draw.AddRectFilled(low, high, plate, 5 * scale);
  draw.AddText({low.x + 12 * scale, low.y + 6 * scale}, white, text.c_str());
  if (both) draw.AddText({low.x + 12 * scale + text_size.x + gap, low.y + 6 * scale}, muted, hint.c_str());
}

}  // namespace archetype
