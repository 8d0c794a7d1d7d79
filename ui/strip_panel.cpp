// The strip: each tile with its fit, its energy and how far that has changed since the drag began.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr double least_change = 0.0005;  // smaller ones would be written as 0.000

void draw_head(Studio& studio) {
  command_button(studio, "strip-worst", "Worst");
  ImGui::SameLine();
  command_button(studio, "strip-random", "Random");
  ImGui::SameLine();
  command_button(studio, "strip-add", std::string(icon::plus) + " Shape in view");
  ImGui::SameLine();
  command_button(studio, "strip-clear", "Clear");
  const char* legend = "energy, and its change since the drag began";
  const float room = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(legend).x;
  ImGui::SameLine();
  if (room < ImGui::GetCursorPosX() + 12 * studio.fonts.scale) {
    ImGui::NewLine();
    return;
  }
  ImGui::SetCursorPosX(room);
  ImGui::AlignTextToFramePadding();
  muted_text(studio, legend);
}

ViewportContent content_of(const StripTile& tile, Backdrop backdrop) {
  ViewportContent content;
  content.fit = tile.fit ? &tile.fit->view : nullptr;
  content.display = tile.shape->display;
  if (tile.fit) content.colours = tile.fit->colours;
  content.view.mean_boxes = false;
  content.view.fitted_boxes = true;
  content.view.ground = false;
  content.backdrop = backdrop;
  return content;
}

// From where the shape in view is seen, once the camera rests.
void draw_tile_picture(Studio& studio, StripTile& tile, ImVec2 size) {
  ViewportState& viewport = studio.viewport;
  const float density = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 1.F);
  TilePicture wanted;
  wanted.shape = tile.shape;
  wanted.fit = tile.fit;
  const bool resting = viewport.action == MouseAction::none && !viewport.panes[0].flight;
  const Camera seen = viewport.panes[0].camera;
  wanted.yaw = resting || !tile.drawn ? seen.yaw : tile.drawn->yaw;
  wanted.pitch = resting || !tile.drawn ? seen.pitch : tile.drawn->pitch;
  wanted.size = {static_cast<int>(std::lround(size.x * density)),
                 static_cast<int>(std::lround(size.y * density)), 1, density * studio.fonts.scale};
  wanted.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  if (tile.drawn == wanted) return;
  const ViewportContent content = content_of(tile, wanted.backdrop);
  Camera camera;
  camera.yaw = wanted.yaw;
  camera.pitch = wanted.pitch;
  if (const auto extent = extent_to_frame(content))
    frame(camera, {wanted.size.width, wanted.size.height}, extent->first, extent->second);
  Scene scene = make_viewport_scene(content);
  scene.hidden_lines = 0;  // too fine to be seen so small
  for (SceneBox& box : scene.boxes) box.fill = 0;
  viewport.renderer.draw(scene, camera, wanted.size, tile.target);
  tile.drawn = wanted;
}

// On a ground of its own: the boxes of the picture reach anywhere.
void draw_text(const Studio& studio, ImVec2 at, const ImVec4& colour, const std::string& text) {
  if (text.empty()) return;
  const float scale = studio.fonts.scale;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImVec4 ground = colours(studio).panel;
  ground.w = 0.75F;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({at.x - 3 * scale, at.y - scale}, {at.x + size.x + 3 * scale, at.y + size.y + scale},
                      ImGui::GetColorU32(ground), 3 * scale);
  draw->AddText(at, ImGui::GetColorU32(colour), text.c_str());
}

void draw_energy(const Studio& studio, const StripTile& tile, ImVec2 low, ImVec2 high) {
  if (!tile.fit) return;
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const float y = high.y - ImGui::GetTextLineHeight() - 3 * scale;
  char text[64];
  std::snprintf(text, sizeof text, "%.3f", energy_without_missing(tile.fit->view).total());
  draw_text(studio, {low.x + 6 * scale, y}, p.text, text);
  if (const auto missing = missing_parts(tile.fit->view); !missing.empty()) {
    const float room = high.x - low.x - 14 * scale - ImGui::CalcTextSize(text).x;
    const std::string lacks = fitted("lacks " + missing.front(), room);
    draw_text(studio, {high.x - 6 * scale - ImGui::CalcTextSize(lacks.c_str()).x, y}, p.warning, lacks);
    return;
  }
  const std::optional<double> change = energy_change(tile);
  if (!change || std::abs(*change) < least_change) return;
  std::snprintf(text, sizeof text, "%+.3f", *change);
  draw_text(studio, {high.x - 6 * scale - ImGui::CalcTextSize(text).x, y}, *change < 0 ? p.good : p.error,
            text);
}

std::string name_of(const Studio& studio, ShapeId id) {
  const std::optional<std::size_t> row = find_row(studio.collection, id);
  return row ? studio.collection.rows()[*row].name : "";
}

void draw_tile(Studio& studio, StripTile& tile, ImVec2 size) {
  const Palette& p = colours(studio);
  const float scale = studio.fonts.scale;
  const std::string name = name_of(studio, tile.id);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + size.x, low.y + size.y);
  ImGui::PushID(static_cast<int>(tile.id));
  const float button = ImGui::GetTextLineHeight() + 4 * scale;
  const ImVec2 close_low(high.x - button, low.y);
  const bool clicked = ImGui::InvisibleButton("tile", size);
  ImGui::SetItemAllowOverlap();
  mark_target(studio, "tile:" + name);
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenOverlapped);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float rounding = 5 * scale;
  draw->AddRectFilled(low, high, ImGui::GetColorU32(p.raised), rounding);
  if (tile.shape && tile.shape->problem.empty()) {
    draw_tile_picture(studio, tile, size);
    draw->AddImageRounded(
        reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(tile.target.texture().name())), low, high,
        {0, 1}, {1, 0}, IM_COL32_WHITE, rounding);
  }
  const bool in_view = studio.ui.shape == tile.id;
  if (hovered || in_view)
    draw->AddRect(low, high, ImGui::GetColorU32(in_view ? p.accent : p.border), rounding, 0, 2 * scale);
  ImGui::PushFont(studio.fonts.small);
  draw_text(studio, {low.x + 6 * scale, low.y + 3 * scale}, in_view ? p.text : p.muted,
            fitted(name, size.x - button - 8 * scale));
  draw_energy(studio, tile, low, high);
  ImGui::PopFont();
  if (hovered) {
    const bool broken = tile.shape && !tile.shape->problem.empty();
    tooltip((name + "\n" + (broken ? tile.shape->problem : "Click to put it under the boxes")).c_str());
  }
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(close_low);
  const bool closed = ImGui::InvisibleButton("out", {button, button});
  mark_target(studio, "tile-out:" + name);
  if (ImGui::IsItemHovered()) tooltip("Take it out of the strip");
  if (hovered || ImGui::IsItemHovered())
    draw->AddText({close_low.x + 4 * scale, close_low.y + 3 * scale}, ImGui::GetColorU32(p.text),
                  icon::close);
  ImGui::SetCursorScreenPos(after);
  ImGui::PopID();
  if (closed)
    remove_from_strip(studio, tile.id);
  else if (clicked)
    show_shape(studio, tile.id);
}

}  // namespace

void draw_strip_panel(Studio& studio) {
  if (studio.collection.rows().size() < 2) {
    empty_hint(studio, "Other shapes",
               "Open a collection: up to eight other shapes show here how the template fits them while you "
               "drag a box.");
    return;
  }
  draw_head(studio);
  const float scale = studio.fonts.scale;
  std::vector<StripTile>& tiles = studio.strip.tiles;
  if (tiles.empty()) {
    muted_paragraph(studio,
                    "No shape is in the strip. Take the worst ones, random ones, or the shape in view.");
    return;
  }
  const float gap = 5 * scale;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float columns = most_strip_shapes;
  const ImVec2 size(std::max(std::floor((room.x - gap * (columns - 1)) / columns), 40 * scale),
                    std::max(room.y - ImGui::GetStyle().ItemSpacing.y, 50 * scale));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    ImGui::SetCursorScreenPos({origin.x + static_cast<float>(i) * (size.x + gap), origin.y});
    draw_tile(studio, tiles[i], size);
  }
}

}  // namespace archetype
