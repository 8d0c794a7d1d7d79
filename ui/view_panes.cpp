#include "ui/view_panes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds flight_time{220};

constexpr std::array<const char*, pane_count> pane_names{"Perspective", "Top", "Front", "Right"};

// Where the flight ends, or the camera stands.
Camera aim_of(const ViewPane& pane) {
  return pane.flight ? pane.flight->to : pane.camera;
}

// Something is moved or drawn over the picture: it stays where it is.
bool held(const Studio& studio) {
  return studio.viewport.action != MouseAction::none || studio.ui.transform ||
         !studio.ui.points.outline.empty();
}

// The shape in view is not drawn yet, or its first fit, which may turn it, is still to come.
bool to_change(const Studio& studio, const ViewportContent& content) {
  if (studio.viewport.display.shape_revision != studio.shape.shape_revision) return true;
  return !content.fit && content.part_template && !content.part_template->parts.empty();
}

void fly(ViewPane& pane, const Camera& to) {
  pane.flight = CameraFlight{pane.camera, to, Clock::now()};
}

void frame_content(ViewPane& pane, const PlacedPane& placed, const ViewportContent& content) {
  Camera to = aim_of(pane);
  const auto room = extent_to_frame(content);
  if (!room) return;
  frame(to, placed.viewport(), room->first, room->second);
  fly(pane, to);
}

}  // namespace

const char* pane_title(const Studio& studio, std::size_t pane) {
  return pane == 0 && studio.ui.view.orthographic ? "Orthographic" : pane_names[pane];
}

ViewPreset preset_of(CameraView view) {
  switch (view) {
    case CameraView::front:
      return ViewPreset::front;
    case CameraView::back:
      return ViewPreset::back;
    case CameraView::left:
      return ViewPreset::left;
    case CameraView::right:
      return ViewPreset::right;
    case CameraView::top:
      return ViewPreset::top;
    case CameraView::bottom:
      return ViewPreset::bottom;
    case CameraView::home:
      return ViewPreset::three_quarter;
  }
  return ViewPreset::three_quarter;
}

bool advance_flight(CameraFlight& flight, Camera& camera) {
  const bool orthographic = camera.orthographic;
  const double t = std::chrono::duration<double>(Clock::now() - flight.start) / flight_time;
  const double eased = t >= 1 ? 1 : t * t * (3 - 2 * t);
  flight.to.orthographic = orthographic;
  camera = blend(flight.from, flight.to, eased);
  camera.orthographic = orthographic;
  return t < 1;
}

ViewPanes make_panes() {
  ViewPanes panes;
  const std::array presets{ViewPreset::three_quarter, ViewPreset::top, ViewPreset::front, ViewPreset::right};
  for (std::size_t i = 1; i < panes.size(); ++i) {
    look_from(panes[i].camera, presets[i]);
    panes[i].camera.orthographic = true;
  }
  return panes;
}

std::vector<PlacedPane> place_panes(const Studio& studio, ImVec2 origin, ImVec2 size) {
  if (size.x < 8 || size.y < 8) return {};
  if (!studio.ui.view.four_views) return {{studio.viewport.current, origin, size}};
  const float gap = std::max(1.0F, std::round(2 * studio.fonts.scale));
  const ImVec2 left_upper(std::floor((size.x - gap) / 2), std::floor((size.y - gap) / 2));
  const ImVec2 right_lower(size.x - gap - left_upper.x, size.y - gap - left_upper.y);
  const float x = origin.x + left_upper.x + gap;
  const float y = origin.y + left_upper.y + gap;
  const auto index = [](PaneKind kind) { return static_cast<std::size_t>(kind); };
  return {{index(PaneKind::top), origin, left_upper},
          {index(PaneKind::perspective), {x, origin.y}, {right_lower.x, left_upper.y}},
          {index(PaneKind::front), {origin.x, y}, {left_upper.x, right_lower.y}},
          {index(PaneKind::right), {x, y}, right_lower}};
}

void take_wishes(Studio& studio, const ViewportContent& content, const std::vector<PlacedPane>& placed) {
  ViewportState& state = studio.viewport;
  state.panes[0].camera.orthographic = studio.ui.view.orthographic;
  const auto wanted = std::exchange(studio.ui.wanted_view, std::nullopt);
  const bool frames = std::exchange(studio.ui.wanted_frame, false) || wanted == CameraView::home;
  if (wanted) {
    Camera to = aim_of(state.panes[0]);
    look_from(to, preset_of(*wanted));
    fly(state.panes[0], to);
  }
  if (!frames) return;
  ViewportContent all = content;
  if (wanted == CameraView::home) all.selected.reset();
  for (const PlacedPane& pane : placed) frame_content(state.panes[pane.index], pane, all);
}

void follow_flight(Studio& studio, const ViewportContent& content, const PlacedPane& placed) {
  ViewPane& pane = studio.viewport.panes[placed.index];
  // Whatever is selected: it is the shape that is brought into sight.
  const auto unselected = [&] {
    ViewportContent all = content;
    all.selected.reset();
    return all;
  };
  if (!pane.framed && studio.viewport.display.shape_revision != 0) {
    if (const auto extent = extent_to_frame(unselected())) {
      frame(pane.camera, placed.viewport(), extent->first, extent->second);
      pane.framed = true;
      pane.seen = {pane.camera, true};  // the boxes alone, maybe: the first shape may outgrow them
    }
  }
  if (pane.flight && !advance_flight(*pane.flight, pane.camera)) {
    if (pane.flight->follows) pane.seen = {pane.camera, true};
    pane.flight.reset();
  }
  if (held(studio) || to_change(studio, content)) return;
  const auto extent = shape_extent(content.display, content.fit);
  if (!extent) {
    if (!studio.shape.record) pane.seen = {pane.camera, true};
    return;
  }
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {(i & 1) != 0 ? extent->second.x : extent->first.x,
                  (i & 2) != 0 ? extent->second.y : extent->first.y,
                  (i & 4) != 0 ? extent->second.z : extent->first.z};
  // The next shape may be there while the camera still flies to the one before.
  const bool outgrown = pane.flight
                            ? pane.flight->follows && !shows_all(pane.flight->to, placed.viewport(), corners)
                            : outgrows(pane.seen, pane.camera, placed.viewport(), corners);
  if (!outgrown) return;
  frame_content(pane, placed, unselected());
  if (pane.flight) pane.flight->follows = true;
}

ScreenRect pane_title_place(const Studio& studio, const PlacedPane& placed) {
  const float scale = studio.fonts.scale;
  ImGui::PushFont(studio.fonts.small);
  const ImVec2 text = ImGui::CalcTextSize(pane_title(studio, placed.index));
  ImGui::PopFont();
  const ImVec2 high(placed.origin.x + placed.size.x - 6 * scale, placed.origin.y + text.y + 11 * scale);
  return {{high.x - text.x - 12 * scale, placed.origin.y + 6 * scale}, high};
}

void draw_pane_title(Studio& studio, const PlacedPane& placed) {
  const float scale = studio.fonts.scale;
  bool& four = studio.ui.view.four_views;
  const char* name = pane_names[placed.index];
  const auto [low, high] = pane_title_place(studio, placed);
  ImGui::SetCursorScreenPos(low);
  ImGui::PushID(name);
  const bool clicked = ImGui::InvisibleButton("title", {high.x - low.x, high.y - low.y});
  ImGui::PopID();
  mark_target(studio, std::string("pane:") + name);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec4 back = hovered ? colours(studio).hovered : colours(studio).panel;
  ImGui::PushFont(studio.fonts.small);
  draw->AddRectFilled(low, high, ImGui::GetColorU32({back.x, back.y, back.z, hovered ? 0.95F : 0.6F}),
                      4 * scale);
  draw->AddText({low.x + 6 * scale, low.y + 2.5F * scale},
                ImGui::GetColorU32(hovered ? colours(studio).text : colours(studio).muted),
                pane_title(studio, placed.index));
  ImGui::PopFont();
  if (hovered)
    tooltip(four ? "Make this view large (4)" : "Four views at once: free, top, front and right (4)");
  if (!clicked) return;
  four = !four;
  studio.viewport.current = placed.index;
}

}  // namespace archetype
