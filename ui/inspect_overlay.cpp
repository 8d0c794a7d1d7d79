#include "ui/inspect_overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "render/camera.h"
#include "ui/heat_map.h"
#include "ui/inspect_scene.h"
#include "ui/studio.h"
#include "ui/viewport_overlay.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

struct Side {
  const InspectSide& side;
  const FitLook* look;  // may be null
  ImVec2 origin;
  Viewport viewport;
  Camera camera;

  std::optional<ImVec2> pixel(const Vec3& point) const {
    const auto at = to_screen(camera, viewport, in_scene(look, point));
    if (!at) return std::nullopt;
    return ImVec2(origin.x + static_cast<float>(at->x), origin.y + static_cast<float>(at->y));
  }
};

void draw_cross(ImDrawList& draw, ImVec2 at, ImU32 colour, float radius) {
  draw.AddCircle(at, radius, IM_COL32(0, 0, 0, 200), 0, radius * 0.55F);
  draw.AddCircle(at, radius, colour, 0, radius * 0.3F);
}

std::string after_name_of(const Studio& studio, const Side& side, std::size_t index) {
  const InspectedShape& shape = *side.side.shape;
  if (!side.look) return shape.fit ? "" : "   not fitted yet";
  char text[128];
  std::snprintf(text, sizeof text, "   %s   yaw %d°   energy %.4f", side.look->part_template->name.c_str(),
                side.look->fit.yaw_quarters * 90, side.look->fit.energy.total());
  std::string title = text;
  if (index != 0) return title;
  if (studio.ui.inspect.step) return title + "   (on its way)";
  const auto shown = shown_alternative(studio);
  if (shown && shown == coming_fit(studio)) return title + "   (as the next fit will find it)";
  if (shown) return title + "   (not the fit of the project)";
  if (shape.fit && shape.fit->status == FitStatus::outlier) return title + "   outlier";
  return title;
}

void draw_title(Studio& studio, ImDrawList& draw, const Side& side, std::size_t index, float width) {
  const float scale = studio.fonts.scale;
  const float room = width - 24 * scale;
  const std::string rest = after_name_of(studio, side, index);
  // Where it gets narrow the name is cut before what is said of the fit.
  const float least = 60 * scale;
  const float left = std::max(room - ImGui::CalcTextSize(rest.c_str()).x, least);
  const std::string text = fitted(fitted(side.side.shape->record.name, left) + rest, room);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at(side.origin.x + 8 * scale, side.origin.y + 8 * scale);
  ImVec4 back = colours(studio).panel;
  back.w = 0.8F;
  draw.AddRectFilled({at.x - 4 * scale, at.y - 2 * scale},
                     {at.x + size.x + 4 * scale, at.y + size.y + 2 * scale}, ImGui::GetColorU32(back),
                     3 * scale);
  draw.AddText(at, ImGui::GetColorU32(colours(studio).text), text.c_str());
}

void describe_sample(Studio& studio, const Side& side, std::uint32_t sample) {
  const FitLook& look = *side.look;
  const std::int16_t label = look.fit.labels[sample];
  const std::string part =
      label == null_label ? "no part" : look.part_template->parts[static_cast<std::size_t>(label)].name;
  char text[256];
  if (label == null_label)
    std::snprintf(text, sizeof text, "null label, costs %.2f\nsmoothness  %.3f", look.terms.features[sample],
                  look.terms.smoothness[sample]);
  else
    std::snprintf(
        text, sizeof text,
        "to its box  %.3f\nfeatures  %.3f\nsmoothness  %.3f\nits correspondence is %.3f away",
        look.terms.shape_to_template[sample], look.terms.features[sample], look.terms.smoothness[sample],
        (look.terms.on_template[sample] - look.fit.to_template(look.shape->samples->points[sample])).norm());
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(part.c_str());
  ImGui::PushFont(studio.fonts.small);
  muted_text(studio, text);
  ImGui::PopFont();
  ImGui::EndTooltip();
}

// Where the place that was picked, on whichever shape, is on this one.
std::optional<Vec3> picked_on(const Studio& studio, const Side& side) {
  const auto& place = studio.ui.selection.place;
  if (!place || !side.look) return std::nullopt;
  for (const TemplateRecord& each : side.side.shape->templates) {
    if (each.id != place->on.part_template || place->on.part >= each.part_template.parts.size()) continue;
    PartPoint point;
    point.part = static_cast<int>(place->on.part);
    point.on_mean = place->canonical;
    point.local = each.part_template.parts[place->on.part].mean_box().to_local(place->canonical);
    return place_on_shape(*side.look, each.part_template, point);
  }
  return std::nullopt;
}

void draw_brush(const Studio& studio, ImDrawList& draw, const Side& side, ImVec2 at) {
  const double units = pixel_size(side.camera, side.viewport);
  const auto radius = static_cast<float>(studio.ui.inspect.brush_radius / std::max(units, 1e-9));
  draw.AddCircle(at, radius, IM_COL32(0, 0, 0, 160), 0, 3);
  draw.AddCircle(at, radius, ImGui::GetColorU32(colours(studio).accent), 0, 1.5F);
}

void draw_pointed(Studio& studio, ImDrawList& draw, const Side& side, std::size_t index) {
  const auto& hovered = studio.inspection.hovered;
  const ImU32 accent = ImGui::GetColorU32(colours(studio).accent);
  const float radius = 6 * studio.fonts.scale;
  if (!hovered || !side.look) return;
  if (hovered->side != index) {
    if (!hovered->on_other) return;
    if (const auto at = side.pixel(*hovered->on_other)) draw_cross(draw, *at, accent, radius);
    return;
  }
  const auto at = side.pixel(hovered->point);
  if (!at) return;
  const bool painting = studio.ui.inspect.painting && index == 0;
  if (painting) {
    draw_brush(studio, draw, side, *at);
    return;
  }
  const auto box =
      to_screen(side.camera, side.viewport,
                in_scene(side.look, side.look->fit.to_shape(side.look->terms.on_template[hovered->sample])));
  const auto from = side.pixel(side.look->shape->samples->points[hovered->sample]);
  if (box && from)
    draw.AddLine(*from,
                 {side.origin.x + static_cast<float>(box->x), side.origin.y + static_cast<float>(box->y)},
                 accent, 2 * studio.fonts.scale);
  draw_cross(draw, *at, accent, radius);
  if (studio.inspection.mouse.action == MouseAction::none) describe_sample(studio, side, hovered->sample);
}

}  // namespace

void draw_inspect_overlay(Studio& studio, std::size_t index, ImVec2 origin, ImVec2 size) {
  const InspectSide& shown = studio.inspection.side(index);
  const bool known = shown.look && shown.look->shape == shown.shape;
  const Side side{shown,
                  known ? shown.look.get() : nullptr,
                  origin,
                  {static_cast<int>(size.x), static_cast<int>(size.y)},
                  studio.inspection.camera};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(origin, {origin.x + size.x, origin.y + size.y}, true);
  if (const auto picked = picked_on(studio, side))
    if (const auto at = side.pixel(*picked)) draw_place_ring(draw, *at, studio.fonts.scale);
  draw_pointed(studio, draw, side, index);
  draw_title(studio, draw, side, index, size.x);
  const InspectOptions& options = studio.ui.inspect;
  const bool heat = options.template_points ||
                    (options.colour != InspectColour::part && options.colour != InspectColour::plain);
  if (heat) draw_heat_legend(draw, studio.fonts, colours(studio), {origin.x + size.x, origin.y + size.y});
  draw.PopClipRect();
}

}  // namespace archetype
