// Handles, names and axes over the picture.
#include "ui/viewport_overlay.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/model/part_colours.h"
#include "render/convert.h"

namespace archetype {
namespace {

// Hues of the axes as in other editors; light enough for either backdrop.
constexpr std::array<ImU32, 3> axis_colours{IM_COL32(232, 84, 84, 255), IM_COL32(96, 176, 64, 255),
                                            IM_COL32(74, 136, 232, 255)};
constexpr ImU32 highlight = IM_COL32(255, 196, 46, 255);
constexpr ImU32 white = IM_COL32(255, 255, 255, 255);
constexpr ImU32 dark_rim = IM_COL32(20, 22, 26, 200);

ImU32 faded(ImU32 colour, float opacity) {
  const auto alpha = static_cast<ImU32>(static_cast<float>(colour >> IM_COL32_A_SHIFT) * opacity);
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

ImVec2 at(ImVec2 origin, const glm::dvec2& pixel) {
  return {origin.x + static_cast<float>(pixel.x), origin.y + static_cast<float>(pixel.y)};
}

ImU32 colour_of(const Handle& handle) {
  if (handle.kind == HandleKind::resize || handle.kind == HandleKind::move_view) return white;
  return axis_colours[static_cast<std::size_t>(handle.axis)];
}

void draw_arrow(ImDrawList& draw, ImVec2 from, ImVec2 to, ImU32 colour, float scale) {
  const glm::vec2 way(to.x - from.x, to.y - from.y);
  const float length = glm::length(way);
  if (length < 1) return;
  const glm::vec2 along = way / length;
  const glm::vec2 across(-along.y, along.x);
  const float head = std::min(13 * scale, length);
  const ImVec2 neck(to.x - along.x * head, to.y - along.y * head);
  const float half = 5.5F * scale;
  draw.AddLine(from, neck, dark_rim, 4.5F * scale);
  draw.AddLine(from, neck, colour, 2.8F * scale);
  draw.AddTriangleFilled(to, {neck.x + across.x * half, neck.y + across.y * half},
                         {neck.x - across.x * half, neck.y - across.y * half}, colour);
}

void draw_handle(ImDrawList& draw, ImVec2 origin, const HandleShape& shape, bool highlighted, float scale) {
  ImU32 colour = highlighted ? highlight : colour_of(shape.handle);
  if (shape.faint && !highlighted) colour = faded(colour, 0.45F);
  std::vector<ImVec2> points;
  for (const glm::dvec2& point : shape.points) points.push_back(at(origin, point));
  switch (shape.form) {
    case HandleForm::dot: {
      const float radius = static_cast<float>(shape.radius) * (highlighted ? 1.25F : 1.F);
      draw.AddCircleFilled(points[0], radius + 1.4F * scale, shape.faint ? faded(dark_rim, 0.5F) : dark_rim);
      draw.AddCircleFilled(points[0], radius, colour);
      return;
    }
    case HandleForm::square:
      draw.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), faded(colour, 0.45F));
      draw.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_Closed,
                       1.5F * scale);
      return;
    case HandleForm::arrow:
      draw_arrow(draw, points[0], points[1], colour, scale);
      return;
    case HandleForm::ring:
      draw.AddPolyline(points.data(), static_cast<int>(points.size()), dark_rim, ImDrawFlags_Closed,
                       4 * scale);
      draw.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_Closed,
                       2.4F * scale);
      return;
  }
}

struct NameTag : ScreenRect {
  std::size_t part = 0;
  double depth = 0;
};

bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

// Corners are numbered by their sides: bits 0, 1 and 2 for x, y and z of the box.
std::optional<glm::dvec2> corner_on_screen(const Box& box, int corner, const GizmoView& view) {
  const Vec3 local((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
  return to_screen(view.camera, view.viewport, to_glm(box.to_world(local)));
}

// Above the corner of the box that is highest on the screen.
std::optional<NameTag> place_name(const TemplatePart& part, std::size_t index, ImVec2 origin,
                                  const GizmoView& view, const ScreenRect& taken) {
  const Box box = part.mean_box();
  std::optional<glm::dvec2> top;
  double left = 0;
  double right = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const auto pixel = corner_on_screen(box, corner, view);
    if (!pixel) return std::nullopt;
    left = top ? std::min(left, pixel->x) : pixel->x;
    right = top ? std::max(right, pixel->x) : pixel->x;
    if (!top || pixel->y < top->y) top = pixel;
  }
  const auto scale = static_cast<float>(view.scale);
  const ImVec2 text = ImGui::CalcTextSize(part.name.c_str());
  const ImVec2 middle = at(origin, {0.5 * (left + right), top->y});
  NameTag tag{{}, index, view_depth(view.camera, to_glm(box.centre))};
  tag.low = {middle.x - 0.5F * text.x - 6 * scale, middle.y - text.y - 9 * scale};
  const bool just_above = tag.low.y < origin.y && middle.y > origin.y - text.y;
  if (just_above) tag.low.y = origin.y + 2 * scale;  // rather than cut off
  const float height = text.y + 5 * scale;
  tag.high = {tag.low.x + text.x + 12 * scale, tag.low.y + height};
  if (overlap(tag, taken)) {
    tag.low.y = taken.high.y + 2 * scale;
    tag.high.y = tag.low.y + height;
  }
  return tag;
}

}  // namespace

ImU32 axis_colour(int axis) {
  return axis_colours[static_cast<std::size_t>(axis)];
}

void draw_handles(ImDrawList& draw, ImVec2 origin, const std::vector<HandleShape>& shapes,
                  const std::optional<Handle>& highlighted, double scale) {
  for (const HandleShape& shape : shapes)
    draw_handle(draw, origin, shape, highlighted == shape.handle, static_cast<float>(scale));
}

void draw_box_edges(ImDrawList& draw, ImVec2 origin, const Box& box, const GizmoView& view) {
  const auto scale = static_cast<float>(view.scale);
  std::array<std::optional<glm::dvec2>, 8> corners;
  for (int corner = 0; corner < 8; ++corner)
    corners[static_cast<std::size_t>(corner)] = corner_on_screen(box, corner, view);
  for (std::size_t from = 0; from < 8; ++from) {
    for (const std::size_t side : {1U, 2U, 4U}) {
      const std::size_t to = from | side;
      if (to == from || !corners[from] || !corners[to]) continue;
      draw.AddLine(at(origin, *corners[from]), at(origin, *corners[to]), dark_rim, 2.6F * scale);
      draw.AddLine(at(origin, *corners[from]), at(origin, *corners[to]), white, 1.2F * scale);
    }
  }
}

void draw_part_names(ImDrawList& draw, ImVec2 origin, const PartTemplate& part_template,
                     std::optional<std::size_t> selected, const GizmoView& view, const ScreenRect& taken) {
  std::vector<NameTag> tags;
  for (std::size_t i = 0; i < part_template.parts.size(); ++i)
    if (const auto tag = place_name(part_template.parts[i], i, origin, view, taken)) tags.push_back(*tag);
  std::stable_sort(tags.begin(), tags.end(), [&](const NameTag& a, const NameTag& b) {
    if ((selected == a.part) != (selected == b.part)) return selected == a.part;
    return a.depth < b.depth;
  });
  const auto scale = static_cast<float>(view.scale);
  std::vector<NameTag> drawn;
  for (const NameTag& tag : tags) {
    if (std::any_of(drawn.begin(), drawn.end(), [&](const NameTag& other) { return overlap(tag, other); }))
      continue;
    drawn.push_back(tag);
    const Rgb rgb = part_colour(part_template, static_cast<int>(tag.part));
    const bool chosen = selected == tag.part;
    draw.AddRectFilled(tag.low, tag.high, IM_COL32(24, 26, 30, chosen ? 235 : 170), 4 * scale);
    draw.AddRect(tag.low, tag.high, IM_COL32(rgb[0], rgb[1], rgb[2], chosen ? 255 : 150), 4 * scale, 0,
                 (chosen ? 1.6F : 1.F) * scale);
    draw.AddText({tag.low.x + 6 * scale, tag.low.y + 2.5F * scale},
                 chosen ? white : IM_COL32(236, 238, 241, 235), part_template.parts[tag.part].name.c_str());
  }
}

void draw_place_ring(ImDrawList& draw, ImVec2 middle, float scale) {
  draw.AddCircle(middle, 9 * scale, dark_rim, 24, 4.5F * scale);
  draw.AddCircle(middle, 9 * scale, highlight, 24, 2.2F * scale);
}

void draw_axes(ImDrawList& draw, ImVec2 origin, const GizmoView& view, ImU32 text_colour) {
  const auto scale = static_cast<float>(view.scale);
  const ImVec2 middle{origin.x + 34 * scale,
                      origin.y + static_cast<float>(view.viewport.height) - 34 * scale};
  const std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  std::array<std::size_t, 3> order{0, 1, 2};
  const glm::dvec3 back = back_axis(view.camera);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return glm::dot(axes[a], back) < glm::dot(axes[b], back); });
  for (const std::size_t k : order) {
    const ImVec2 way{static_cast<float>(glm::dot(axes[k], right_axis(view.camera))) * scale,
                     static_cast<float>(-glm::dot(axes[k], up_axis(view.camera))) * scale};
    draw.AddLine(middle, {middle.x + 20 * way.x, middle.y + 20 * way.y}, axis_colours[k], 2 * scale);
    const char name[] = {static_cast<char>('x' + k), '\0'};
    const ImVec2 size = ImGui::CalcTextSize(name);
    draw.AddText({middle.x + 27 * way.x - 0.5F * size.x, middle.y + 27 * way.y - 0.5F * size.y}, text_colour,
                 name);
  }
}

}  // namespace archetype
