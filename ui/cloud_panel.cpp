// All points of a cluster, of the selected shapes or of the collection in the space of their templates
// (figure 8): rigid beside deformed with one camera, or one cloud between the two.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/convert.h"
#include "render/picking.h"
#include "ui/cloud_overlay.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<CloudPane> place(const Studio& studio, ImVec2 origin, ImVec2 size) {
  if (size.x < 16 || size.y < 16) return {};
  const CloudChoice& choice = studio.ui.cloud;
  if (!choice.pair) return {{0, choice.blend, origin, size}};
  const float gap = std::max(1.0F, std::round(2 * studio.fonts.scale));
  const float left = std::floor((size.x - gap) / 2);
  return {{0, 0, origin, {left, size.y}},
          {1, 1, {origin.x + left + gap, origin.y}, {size.x - left - gap, size.y}}};
}

CloudPictureKey key_of(const Studio& studio, const CloudPane& pane) {
  const float density = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 1.F);
  CloudPictureKey key;
  key.camera = studio.cloud.camera;
  key.size = {static_cast<int>(std::lround(pane.size.x * density)),
              static_cast<int>(std::lround(pane.size.y * density)), 1, density * studio.fonts.scale};
  key.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  key.blend = pane.blend;
  key.points = studio.cloud.content->points;
  key.colours = studio.cloud.colours;
  return key;
}

void move_to(CloudView& view, const Camera& to) {
  view.flight = CameraFlight{view.camera, to, Clock::now()};
}

// Enough of them to frame all by, at either end of the blend.
std::vector<glm::vec3> some_of(const PointGeometry& points) {
  constexpr std::size_t enough = 20'000;
  const std::size_t step = points.positions.size() / enough + 1;
  std::vector<glm::vec3> some;
  for (std::size_t i = 0; i < points.positions.size(); i += step) {
    some.push_back(points.positions[i]);
    if (i < points.moved.size()) some.push_back(points.moved[i]);
  }
  return some;
}

void follow_camera_wishes(Studio& studio, const CloudPane& pane) {
  CloudView& view = studio.cloud;
  const PointGeometry& points = *view.content->points;
  const auto framed = [&](Camera camera) {
    constexpr double margin = 0.16;  // the caption stands over the picture
    frame_points(camera, pane.viewport(), some_of(points), margin);
    return camera;
  };
  view.camera.orthographic = studio.ui.view.orthographic;
  if (!view.framed) {
    view.camera = framed(view.camera);
    view.framed = true;
  }
  const auto wanted = std::exchange(studio.ui.wanted_view, std::nullopt);
  const bool frames = std::exchange(studio.ui.wanted_frame, false) || wanted == CameraView::home;
  if (wanted || frames) {
    Camera to = view.flight ? view.flight->to : view.camera;
    if (wanted) look_from(to, preset_of(*wanted));
    move_to(view, frames ? framed(to) : to);
  }
  if (view.flight && !advance_flight(*view.flight, view.camera)) view.flight.reset();
  if (view.turning > 0) {
    --view.turning;
    orbit(view.camera, 0.02, 0);
  }
}

std::optional<std::size_t> point_under(Studio& studio, const CloudPane& pane, const glm::dvec2& cursor) {
  CloudView& view = studio.cloud;
  const CloudView::HoverKey key{view.camera, cursor, pane.index, pane.blend, view.content.get()};
  if (view.hover_key == key) return view.hovered_point;
  const Pick pick = pick_surface(cloud_scene(key_of(studio, pane)), view.camera, pane.viewport(), cursor);
  view.hover_key = key;
  view.hovered_point = pick.kind == PickKind::point ? std::optional(pick.element) : std::nullopt;
  return view.hovered_point;
}

void select_point(Studio& studio, std::optional<std::size_t> point, bool add) {
  const CloudContent& content = *studio.cloud.content;
  ExplorerSelection& selection = studio.ui.selection;
  if (!point) {
    if (!add) select_only(selection, {});
    selection.place.reset();
    return;
  }
  const CloudPoint& of = content.of[*point];
  const CloudShape& shape = content.shapes[of.shape];
  if (add)
    toggle_selected(selection, shape.id);
  else if (studio.ui.cloud.scope != CloudScope::selection)  // else the others would be lost from sight
    select_only(selection, {shape.id});
  show_shape(studio, shape.id);
  studio.ui.grid.scroll_to_shape = true;
  selection.place.reset();
  if (of.part == null_label) return;
  selection.part = {content.templates[shape.part_template].id, static_cast<std::size_t>(of.part)};
  const glm::vec3 at = content.points->moved[*point];
  selection.place = PickedPlace{*selection.part, to_eigen(glm::dvec3(at)), shape.id};
}

std::string name_of(const Studio& studio, ShapeId id) {
  const std::optional<std::size_t> row = find_row(studio.collection, id);
  return row ? studio.collection.rows()[*row].name : "a shape that has gone";
}

void tell_of_point(const Studio& studio, std::size_t point) {
  const CloudContent& content = *studio.cloud.content;
  const CloudPoint& of = content.of[point];
  const PartTemplate& part_template = content.templates[content.shapes[of.shape].part_template].part_template;
  const std::string part =
      of.part == null_label ? "no part" : part_template.parts[static_cast<std::size_t>(of.part)].name;
  char moved[64];
  std::snprintf(moved, sizeof moved, "%.3f", static_cast<double>(content.displacement[point]));
  ImGui::SetTooltip("%s\n%s, moved by %s", name_of(studio, content.shapes[of.shape].id).c_str(), part.c_str(),
                    moved);
}

void follow_mouse_in(Studio& studio, const std::vector<CloudPane>& panes) {
  CloudView& view = studio.cloud;
  const bool held = view.mouse.action != MouseAction::none;
  for (const CloudPane& pane : panes) {
    const MouseInput mouse = read_mouse(static_cast<int>(pane.index), pane.origin, pane.size);
    mark_target(studio, pane.index == 0 ? "cloud" : "cloud:deformed");
    if (held ? pane.index != view.mouse_pane : !mouse.over) continue;
    view.mouse_pane = pane.index;
    if (mouse.pressed || mouse.wheel != 0) view.flight.reset();
    const GizmoView gizmo{view.camera, pane.viewport(), static_cast<double>(studio.fonts.scale)};
    const bool clicked = follow_camera_mouse(view.mouse, studio.ui.navigation, mouse, gizmo, view.camera);
    if (!mouse.over || (view.mouse.action != MouseAction::none && view.mouse.action != MouseAction::click))
      continue;
    const auto point = point_under(studio, pane, mouse.cursor);
    if (clicked) select_point(studio, point, mouse.ctrl || mouse.shift);
    if (!point) continue;
    studio.ui.selection.hovering = view.content->shapes[view.content->of[*point].shape].id;
    tell_of_point(studio, *point);
  }
}

void draw_texture(const RenderTarget& target, const CloudPane& pane, ImU32 tint) {
  // OpenGL's first row is the lowest.
  ImGui::GetWindowDrawList()->AddImage(
      reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(target.texture().name())), pane.origin,
      {pane.origin.x + pane.size.x, pane.origin.y + pane.size.y}, {0, 1}, {1, 0}, tint);
}

void draw_pictures(Studio& studio, const std::vector<CloudPane>& panes) {
  CloudView& view = studio.cloud;
  const bool moving = (view.mouse.action != MouseAction::none && view.mouse.action != MouseAction::click) ||
                      view.flight || view.turning > 0;
  const auto& frames = studio.frames.milliseconds();
  const bool changed = std::ranges::any_of(
      panes, [&](const CloudPane& pane) { return view.pictures[pane.index].drawn != key_of(studio, pane); });
  const std::size_t most =
      points_for_frame(frames.empty() ? 30 : frames.back(), moving || changed) / panes.size();
  const Rgb mark = studio.theme == Theme::light ? Rgb{20, 22, 26} : Rgb{255, 255, 255};
  for (const CloudPane& pane : panes) {
    CloudPicture& picture = view.pictures[pane.index];
    const CloudPictureKey key = key_of(studio, pane);
    draw_cloud_picture(studio.viewport.renderer, picture, key, moving, most);
    draw_cloud_marks(studio.viewport.renderer, picture, key, {view.marked, mark});
    // What is not marked steps back.
    draw_texture(picture.visible(), pane, IM_COL32(255, 255, 255, view.marked ? 110 : 255));
    if (view.marked) draw_texture(picture.marks, pane, IM_COL32_WHITE);
  }
}

// At the upper edge of the one cloud.
void draw_blend(Studio& studio, const CloudPane& pane) {
  const float scale = studio.fonts.scale;
  const float width = std::min(180 * scale, 0.3F * pane.size.x);
  const float names = ImGui::CalcTextSize("Rigid").x + ImGui::CalcTextSize("Deformed").x + 14 * scale;
  ImGui::SetCursorScreenPos(
      {pane.origin.x + pane.size.x - width - names - 12 * scale, pane.origin.y + 8 * scale});
  ImGui::AlignTextToFramePadding();
  muted_text(studio, "Rigid");
  ImGui::SameLine(0, 7 * scale);
  ImGui::SetNextItemWidth(width);
  ImGui::SliderFloat("##blend", &studio.ui.cloud.blend, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  mark_target(studio, "cloud:blend");
  tooltip("How much of the deformation of each part is taken out");
  ImGui::SameLine(0, 7 * scale);
  muted_text(studio, "Deformed");
}

// Over what is there already, or alone.
void draw_progress(Studio& studio, ImVec2 origin, ImVec2 size) {
  const CloudProgress& progress = *studio.cloud.progress;
  const std::size_t total = progress.total;
  const float share = total > 0 ? static_cast<float>(progress.done) / static_cast<float>(total) : 0;
  const std::string text = "Co-aligning " + count_text(studio.cloud.asked.shapes.size()) +
                           (studio.cloud.asked.shapes.size() == 1 ? " shape" : " shapes");
  const float width = std::min(260 * studio.fonts.scale, size.x - 20);
  const float y = studio.cloud.content ? 56 * studio.fonts.scale : 0.45F * size.y;
  ImGui::SetCursorScreenPos({origin.x + (size.x - width) / 2, origin.y + y});
  ImGui::ProgressBar(share, {width, 0}, text.c_str());
}

void draw_nothing(Studio& studio) {
  const bool fitted_ones =
      std::ranges::any_of(studio.collection.rows(), [](const ShapeRow& row) { return row.fit.has_value(); });
  const char* title = "No co-aligned points yet";
  if (!studio.collection.open())
    empty_hint(studio, title, "Open a collection; once its shapes are fitted, all their points meet here.");
  else if (!fitted_ones)
    empty_hint(studio, title,
               "Fit a template to all shapes (Ctrl+Enter) or learn from them (Ctrl+L): then all their points "
               "meet here in the space of the template, before and after the deformation is taken out.");
  else if (studio.ui.cloud.scope == CloudScope::selection)
    empty_hint(studio, "No fitted shape is selected",
               "Select shapes in the grid, in the clusters or by a click on their points, or show the whole "
               "collection.");
  else
    empty_hint(studio, title, "All of these shapes are outliers.");
}

}  // namespace

void draw_cloud(Studio& studio) {
  CloudView& view = studio.cloud;
  follow_cloud(studio);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  view.shown = 0;
  const bool something = view.content && !view.content->of.empty();
  const std::vector<CloudPane> panes = something ? place(studio, origin, size) : std::vector<CloudPane>{};
  if (!panes.empty()) {
    follow_camera_wishes(studio, panes.front());
    follow_mouse_in(studio, panes);
    draw_pictures(studio, panes);
    view.shown = panes.size();
    for (const CloudPane& pane : panes) draw_cloud_overlay(studio, pane, &pane == &panes.back());
    if (!studio.ui.cloud.pair) draw_blend(studio, panes.front());
  }
  if (!view.reader.idle() && view.progress && size.x > 40)
    draw_progress(studio, origin, size);
  else if (!something)
    draw_nothing(studio);
}

}  // namespace archetype
