// One frame of the viewport: takes over geometry, follows wishes and the mouse, draws what has changed.
#include "ui/viewport.h"
#include "ui/part_highlight.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "render/gl/draw.h"
#include "ui/camera_mouse.h"
#include "ui/edit_overlay.h"
#include "ui/heat_map.h"
#include "ui/picked_place.h"
#include "ui/selection.h"
#include "ui/spread_mouse.h"
#include "ui/studio.h"
#include "ui/template_compare.h"
#include "ui/viewport_mouse.h"
#include "ui/viewport_overlay.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds rest_before_fine_picture{180};
constexpr int fine = 2;  // supersampling of a picture that stands still

void take_over_shape(Studio& studio) {
  ViewportState& state = studio.viewport;
  const ShapeInView& shape = studio.shape;
  ShapeDisplayRequest request{shape.mesh, shape.samples, {}, shape.shape_revision, state.most_moving};
  if (shape.record) request.frame = shape.record->frame;
  if (state.asked_display != shape.shape_revision) {
    state.asked_display = shape.shape_revision;
    state.coarse_worker.cancel();
    state.worker.request(request, true);
  }
  // The boxes of a shape do not belong over the one before it.
  if (!shape.record) state.display = {};
  if (auto made = state.worker.poll(); made && made->shape_revision == shape.shape_revision) {
    state.display = std::move(*made);
    if (state.display.mesh && state.display.mesh->triangle_count() > state.most_moving)
      state.coarse_worker.request(request, true);
  }
  if (const std::string problem = state.worker.take_problem(); !problem.empty()) {
    state.display = {};  // rather nothing than the shape before
    say(studio, Severity::error, "the shape cannot be drawn: " + problem);
  }
  if (auto made = state.coarse_worker.poll(); made && made->shape_revision == state.display.shape_revision)
    state.display.coarse = std::move(made->mesh);
  const std::optional<int> part = shape.fit ? highlighted_in_view(studio, *shape.fit) : std::nullopt;
  if (state.coloured_fit == shape.fit_revision && state.coloured_display == state.display.shape_revision &&
      state.coloured_by == studio.ui.view.colour && state.coloured_part == part)
    return;
  state.coloured_part = part;
  state.coloured_by = studio.ui.view.colour;
  state.coloured_fit = shape.fit_revision;
  state.coloured_display = state.display.shape_revision;
  state.colours =
      shape.fit ? colours_of_fit(*shape.fit, state.display, state.coloured_by, part) : ShapeColours{};
}

// Anew when the collection has changed and nothing writes to it any more.
void take_over_average(Studio& studio) {
  ViewportState& state = studio.viewport;
  if (!studio.ui.view.average) {
    if (std::exchange(state.asked_average, std::nullopt)) state.average_worker.cancel();
    return;
  }
  if (!studio.collection.open()) state.average.reset();
  if (auto made = state.average_worker.poll()) state.average = std::move(made);
  const std::uint64_t revision = studio.collection.revision;
  if (!studio.collection.open() || state.asked_average == revision || !studio.jobs.resting()) return;
  state.asked_average = revision;
  state.average_worker.request({studio.collection.path, revision}, true);
}

bool moving(const Studio& studio) {
  const ViewportState& state = studio.viewport;
  return studio.drag || state.flying() ||
         (state.action != MouseAction::none && state.action != MouseAction::click);
}

ViewportContent content_of(const Studio& studio) {
  const ViewportState& state = studio.viewport;
  ViewportContent content;
  content.part_template = shown_template(studio).get();
  if (!studio.ui.look) content.compared = compared_template(studio).get();
  content.fit = studio.shape.fit.get();
  content.display = state.display;
  content.colours = state.colours;
  content.average = state.average ? &*state.average : nullptr;
  content.view = studio.ui.view;
  if (!studio.ui.look) {
    content.selected = studio.ui.part;
    content.also_selected = studio.ui.also_selected;
  }
  content.hovered = state.hovered;
  content.moving = moving(studio);
  content.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  return content;
}

// The title lies over it.
MouseInput mouse_over(Studio& studio, const PlacedPane& placed) {
  const MouseInput mouse = read_mouse(static_cast<int>(placed.index), placed.origin, placed.size);
  mark_target(studio, placed.index == 0 ? "viewport" : "viewport:" + std::to_string(placed.index));
  return mouse;
}

// Only when something has changed; once it has not for a while, in a finer picture.
void draw_picture(Studio& studio, const Scene& scene, const PlacedPane& placed) {
  ViewportState& state = studio.viewport;
  ViewPane& pane = state.panes[placed.index];
  const ImVec2 size = placed.size;
  const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
  const float pixels = std::max(density.x, 1.F);
  PictureKey key;
  key.camera = pane.camera;
  key.size = {static_cast<int>(std::lround(size.x * pixels)), static_cast<int>(std::lround(size.y * pixels)),
              1, pixels * studio.fonts.scale};
  key.view = studio.ui.view;
  key.backdrop = scene.backdrop;
  key.coarse = moving(studio) && state.display.coarse;
  key.document_revision = studio.history.revision();
  if (studio.ui.look) key.looked_at = studio.ui.look->part_template;
  key.compared = compared_template(studio);
  key.fit_revision = state.coloured_fit;
  key.coloured_part = state.coloured_part;
  key.display_revision = state.display.shape_revision;
  if (studio.ui.view.average && state.average) key.average = state.average->points;
  key.selected = selected_parts(studio.ui);
  key.hovered = state.hovered;
  const bool changed = pane.drawn != key;
  if (changed) pane.changed_at = Clock::now();
  const bool rested = Clock::now() - pane.changed_at > rest_before_fine_picture;
  const bool refine = !changed && !pane.drawn_fine && rested && state.action == MouseAction::none;
  if (!changed && !refine) return;
  PictureSize drawn_size = key.size;
  if (refine) drawn_size.supersample = fine;
  state.renderer.draw(scene, pane.camera, drawn_size, pane.target);
  pane.drawn = key;
  pane.drawn_fine = refine;
}

void draw_overlay(Studio& studio, const PlacedPane& placed, const GizmoView& view,
                  const std::vector<HandleShape>& shapes) {
  const ImVec2 origin = placed.origin;
  const ImVec2 size = placed.size;
  const ViewportState& state = studio.viewport;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(origin, {origin.x + size.x, origin.y + size.y}, true);
  const ScreenRect title = pane_title_place(studio, placed);
  const std::shared_ptr<const PartTemplate> shown = shown_template(studio);
  if (shown && studio.ui.view.mean_boxes && studio.ui.view.part_names)
    draw_part_names(draw, origin, *shown, studio.ui.part, view, title);
  const auto of_mouse = state.drag ? std::optional(state.drag->handle) : state.handle;
  const auto highlighted = placed.index == state.current ? of_mouse : std::nullopt;
  const std::vector<PlacedPart> selected = selected_boxes(studio);
  if (selected.size() > 1 && !shapes.empty()) draw_box_edges(draw, origin, *held_box(selected), view);
  if (const auto place = picked_in_viewport(studio))
    if (const auto pixel = to_screen(view.camera, view.viewport, *place))
      draw_place_ring(draw,
                      {origin.x + static_cast<float>(pixel->x), origin.y + static_cast<float>(pixel->y)},
                      studio.fonts.scale);
  draw_handles(draw, origin, shapes, highlighted, view.scale);
  if (state.snapped) draw_snapped(draw, origin, *state.snapped, view);
  if (placed.index == state.current) {
    draw_transform(studio, draw, origin, view, title);
    draw_point_tool(studio, draw, origin, view, title);
  }
  draw_spread_dots(studio, draw, origin, view);
  const bool one_of_four = studio.ui.view.four_views && placed.index != 0;
  if (studio.ui.view.colour == SurfaceColour::cost && state.colours.samples && !one_of_four)
    draw_heat_legend(draw, studio.fonts, colours(studio), {origin.x + size.x, origin.y + size.y});
  draw_axes(draw, origin, view, ImGui::GetColorU32(colours(studio).text));
  draw.PopClipRect();
}

std::vector<HandleShape> handles_of_selection(const Studio& studio, const GizmoView& view) {
  if (studio.ui.view.spread) return {};  // they would lie among the dots of the spread
  if (studio.ui.look || !studio.ui.view.mean_boxes || by_outline(studio.ui.points.tool)) return {};
  const std::optional<Box> held = held_box(selected_boxes(studio));
  return held ? handle_shapes(*held, studio.ui.tool, view) : std::vector<HandleShape>{};
}

GizmoView view_of(const Studio& studio, const PlacedPane& placed) {
  return {studio.viewport.panes[placed.index].camera, placed.viewport(),
          static_cast<double>(studio.fonts.scale)};
}

// The pane under the mouse becomes the current one, unless the mouse is held from another.
void follow_mouse_in(Studio& studio, const std::vector<PlacedPane>& panes) {
  ViewportState& state = studio.viewport;
  const bool held = state.action != MouseAction::none || studio.ui.transform;
  std::optional<std::size_t> with_mouse;
  std::vector<MouseInput> inputs;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    inputs.push_back(mouse_over(studio, panes[i]));
    if (held ? panes[i].index == state.current : inputs[i].over) with_mouse = i;
  }
  if (with_mouse) state.current = panes[*with_mouse].index;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (panes[i].index != state.current) continue;
    const GizmoView view = view_of(studio, panes[i]);
    if (!studio.ui.transform && !by_outline(studio.ui.points.tool) && follow_spread(studio, inputs[i], view))
      continue;
    follow_mouse(studio, inputs[i], make_viewport_scene(content_of(studio)), view,
                 handles_of_selection(studio, view));
  }
}

void draw_pane(Studio& studio, const PlacedPane& placed) {
  draw_picture(studio, make_viewport_scene(content_of(studio)), placed);
  const gl::Texture& texture = studio.viewport.panes[placed.index].target.texture();
  // OpenGL's first row is the lowest.
  ImGui::GetWindowDrawList()->AddImage(
      reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name())), placed.origin,
      {placed.origin.x + placed.size.x, placed.origin.y + placed.size.y}, {0, 1}, {1, 0});
  const GizmoView view = view_of(studio, placed);
  draw_overlay(studio, placed, view, handles_of_selection(studio, view));
  draw_pane_title(studio, placed);
}

}  // namespace

ViewportState::ViewportState(const std::filesystem::path& shaders, std::function<void()> wake)
    : renderer(shaders),
      most_moving(gl::in_software() ? most_moving_in_software : most_moving_triangles),
      worker(make_shape_display, wake),
      coarse_worker(make_coarse_mesh, wake),
      average_worker(make_average_shape, std::move(wake)) {}

bool ViewportState::flying() const {
  return std::ranges::any_of(shown, [&](std::size_t index) { return panes[index].flight.has_value(); });
}

void draw_viewport(Studio& studio) {
  ViewportState& state = studio.viewport;
  take_over_shape(studio);
  take_over_average(studio);
  draw_look_strip(studio);
  // Only one view turns.
  if (studio.ui.wanted_view && studio.ui.wanted_view != CameraView::home) state.current = 0;
  const std::vector<PlacedPane> panes =
      place_panes(studio, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail());
  state.shown.clear();
  for (const PlacedPane& pane : panes) state.shown.push_back(pane.index);
  const ViewportContent content = content_of(studio);
  take_wishes(studio, content, panes);
  for (const PlacedPane& pane : panes) follow_flight(studio, content, pane);
  follow_mouse_in(studio, panes);
  for (const PlacedPane& pane : panes) draw_pane(studio, pane);
}

bool viewport_busy(const ViewportState& state, std::uint64_t shape_revision) {
  const auto refining = [&](std::size_t index) {
    const ViewPane& pane = state.panes[index];
    return pane.flight || (pane.drawn && !pane.drawn_fine && state.action == MouseAction::none);
  };
  return !state.worker.idle() || !state.average_worker.idle() || state.asked_display != shape_revision ||
         std::ranges::any_of(state.shown, refining);
}

}  // namespace archetype
