// The middle of the window while a single fit is inspected: one shape, or two side by side under one camera.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/convert.h"
#include "render/picking.h"
#include "ui/inspect_brush.h"
#include "ui/inspect_overlay.h"
#include "ui/inspect_panels.h"
#include "ui/inspect_scene.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds rest_before_fine_picture{180};
constexpr int fine = 2;
constexpr double brush_per_notch = 1.15;

struct PlacedSide {
  std::size_t index = 0;
  ImVec2 origin;
  ImVec2 size;
  Viewport viewport() const { return {static_cast<int>(size.x), static_cast<int>(size.y)}; }
};

std::vector<PlacedSide> place_sides(const Studio& studio, ImVec2 origin, ImVec2 size) {
  const float gap = 3 * studio.fonts.scale;
  if (size.x < 2 * gap + 2 || size.y < 2) return {};
  if (!studio.ui.inspect.beside) return {{0, origin, size}};
  const float width = std::floor((size.x - gap) / 2);
  return {{0, origin, {width, size.y}}, {1, {origin.x + width + gap, origin.y}, {width, size.y}}};
}

InspectContent content_of(const Studio& studio, std::size_t index) {
  const InspectSide& side = studio.inspection.side(index);
  InspectContent content;
  content.shape = side.shape;
  if (side.look && side.look->shape == side.shape) content.look = side.look;
  if (content.look) content.colours = side.colours;  // those of the shape before have other faces
  content.options = studio.ui.inspect;
  if (content.look) content.part = inspected_part(studio, *content.look);
  content.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  const ShapeCorrection* correction = correction_of(studio.history.current(), side.shape->record.id);
  if (content.look && correction && correction->sampling == sampling_of(side.shape->record))
    content.pinned =
        pinned_labels(correction->pinned, *content.look->part_template, side.shape->samples->size());
  return content;
}

void colour(const Studio& studio, InspectSide& side) {
  const InspectColour by = studio.ui.inspect.colour;
  const auto part = side.look ? inspected_part(studio, *side.look) : std::nullopt;
  if (side.coloured == side.look && side.coloured_by == by && side.coloured_part == part) return;
  side.coloured = side.look;
  side.coloured_by = by;
  side.coloured_part = part;
  side.colours = side.look ? inspect_colours(*side.look, by, part) : ShapeColours{};
}

void draw_picture(Studio& studio, const PlacedSide& placed) {
  Inspection& inspection = studio.inspection;
  InspectSide& side = inspection.side(placed.index);
  const InspectOptions& options = studio.ui.inspect;
  const float pixels = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 1.F);
  InspectPicture key;
  key.camera = inspection.camera;
  key.size = {static_cast<int>(std::lround(placed.size.x * pixels)),
              static_cast<int>(std::lround(placed.size.y * pixels)), 1, pixels * studio.fonts.scale};
  key.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  key.look = side.look;
  key.shape = side.shape;
  key.colour = options.colour;
  key.shown = {options.fitted_boxes, options.mean_boxes, options.template_points, options.correspondences,
               options.samples};
  key.corrections = studio.history.current().corrections;
  if (side.look) key.part = inspected_part(studio, *side.look);
  const bool changed = side.drawn != key;
  if (changed) side.changed_at = Clock::now();
  const bool rested = Clock::now() - side.changed_at > rest_before_fine_picture;
  const bool refine = !changed && !side.drawn_fine && rested && !inspection.stroking &&
                      inspection.mouse.action == MouseAction::none;
  if (changed || refine) {
    PictureSize size = key.size;
    if (refine) size.supersample = fine;
    studio.viewport.renderer.draw(make_inspect_scene(content_of(studio, placed.index)), inspection.camera,
                                  size, side.target);
    side.drawn = key;
    side.drawn_fine = refine;
  }
  // OpenGL's first row is the lowest.
  ImGui::GetWindowDrawList()->AddImage(
      reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(side.target.texture().name())), placed.origin,
      {placed.origin.x + placed.size.x, placed.origin.y + placed.size.y}, {0, 1}, {1, 0});
}

// What can be pointed at.
struct Pickable {
  InspectContent content;
  Scene scene;
  Pickable(const Studio& studio, const PlacedSide& placed)
      : content(content_of(studio, placed.index)), scene(make_pick_scene(content)) {}
};

std::optional<InspectedPlace> place_under(const Pickable& pickable, const Camera& camera,
                                          const PlacedSide& placed, const glm::dvec2& cursor) {
  const InspectContent& content = pickable.content;
  const Pick pick = pick_surface(pickable.scene, camera, placed.viewport(), cursor);
  if (pick.kind == PickKind::nothing) return std::nullopt;
  InspectedPlace place;
  place.side = placed.index;
  place.point = on_shape(content.look.get(), pick.position);
  const auto& points = content.shape->samples->points;
  const auto nearest =
      std::ranges::min_element(points, {}, [&](const Vec3& p) { return (p - place.point).squaredNorm(); });
  place.sample = static_cast<std::uint32_t>(nearest - points.begin());
  return place;
}

// What the cursor points at, and where that is on the other shape.
std::optional<InspectedPlace> linked_place_under(const Studio& studio, const PlacedSide& placed,
                                                 const glm::dvec2& cursor) {
  const Inspection& inspection = studio.inspection;
  const Pickable pickable(studio, placed);
  std::optional<InspectedPlace> place = place_under(pickable, inspection.camera, placed, cursor);
  const std::shared_ptr<const FitLook>& look = pickable.content.look;
  const InspectSide& other = inspection.side(1 - placed.index);
  if (place && studio.ui.inspect.beside && look && other.look && other.look->shape == other.shape) {
    if (const auto on_template = place_on_template(*look, place->point))
      place->on_other = place_on_shape(*other.look, *look->part_template, *on_template);
  }
  return place;
}

// Picks the place for all views.
void pick_place(Studio& studio, const InspectedPlace& place) {
  const InspectSide& side = studio.inspection.side(place.side);
  if (!side.look || !side.shape->fit) return;
  const auto on_template = place_on_template(*side.look, place.point);
  if (!on_template) {
    studio.ui.selection.place.reset();
    return;
  }
  const PartOfTemplate part{inspected_template(studio, place.side),
                            static_cast<std::size_t>(on_template->part)};
  studio.ui.selection.part = part;
  studio.ui.selection.place = PickedPlace{part, on_template->on_mean, side.shape->record.id};
}

// Ctrl and the wheel are for the brush.
void resize_brush(Studio& studio, MouseInput& mouse) {
  InspectOptions& options = studio.ui.inspect;
  if (!mouse.over || !mouse.ctrl || !options.painting || mouse.wheel == 0) return;
  options.brush_radius = std::clamp(options.brush_radius * std::pow(brush_per_notch, mouse.wheel),
                                    least_brush_radius, largest_brush_radius);
  mouse.wheel = 0;
}

// What the brush has passed over since the frame before.
std::vector<InspectedPlace> places_on_way(const Studio& studio, const PlacedSide& placed,
                                          const MouseInput& mouse) {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  const glm::dvec2 moved = mouse.pressed ? glm::dvec2(0, 0) : glm::dvec2(delta.x, delta.y);
  const double pixel = pixel_size(studio.inspection.camera, placed.viewport());
  const double radius = studio.ui.inspect.brush_radius / std::max(pixel, 1e-9);
  const Pickable pickable(studio, placed);
  std::vector<InspectedPlace> places;
  for (const glm::dvec2& cursor : way_of_brush(mouse.cursor, moved, radius))
    if (auto place = place_under(pickable, studio.inspection.camera, placed, cursor))
      places.push_back(*place);
  return places;
}

// True while the mouse paints.
bool follow_brush(Studio& studio, const PlacedSide& placed, const MouseInput& mouse) {
  const std::size_t side = placed.index;
  Inspection& inspection = studio.inspection;
  const bool for_camera = mouse.shift || (studio.ui.navigation == Navigation::maya && mouse.alt);
  const bool on_shape = side == 0 && inspection.hovered && inspection.hovered->side == 0;
  if (mouse.pressed && mouse.button == ImGuiMouseButton_Left && studio.ui.inspect.painting && !for_camera &&
      on_shape)
    inspection.stroking = true;
  if (!inspection.stroking || side != 0) return inspection.stroking;
  if (mouse.held)
    paint(studio, content_of(studio, 0), placed.viewport(), places_on_way(studio, placed, mouse));
  else
    end_stroke(studio);
  return true;
}

void follow_mouse(Studio& studio, const PlacedSide& placed) {
  Inspection& inspection = studio.inspection;
  MouseInput mouse = read_mouse(static_cast<int>(placed.index), placed.origin, placed.size);
  mark_target(studio, placed.index == 0 ? "inspect:shape" : "inspect:beside");
  const MouseAction action = inspection.mouse.action;
  const bool camera_moves = action != MouseAction::none && action != MouseAction::click;
  const bool other_holds =
      (inspection.stroking || action != MouseAction::none) && inspection.held != placed.index;
  if (mouse.over && !other_holds && !camera_moves)
    if (auto place = linked_place_under(studio, placed, mouse.cursor)) inspection.hovered = place;
  if (mouse.over) studio.ui.selection.hovering = inspection.side(placed.index).shape->record.id;
  resize_brush(studio, mouse);
  if (other_holds) return;
  if (mouse.pressed) inspection.held = placed.index;
  if (follow_brush(studio, placed, mouse)) return;
  const GizmoView view{inspection.camera, placed.viewport(), static_cast<double>(studio.fonts.scale)};
  if (!follow_camera_mouse(inspection.mouse, studio.ui.navigation, mouse, view, inspection.camera)) return;
  if (inspection.hovered)
    pick_place(studio, *inspection.hovered);
  else
    studio.ui.selection.place.reset();
}

void frame_shapes(Studio& studio, const PlacedSide& placed) {
  Inspection& inspection = studio.inspection;
  const bool wanted = std::exchange(studio.ui.wanted_frame, false);
  const auto view = std::exchange(studio.ui.wanted_view, std::nullopt);
  if (view) {
    constexpr std::array presets{ViewPreset::front,        ViewPreset::back, ViewPreset::left,
                                 ViewPreset::right,        ViewPreset::top,  ViewPreset::bottom,
                                 ViewPreset::three_quarter};
    look_from(inspection.camera, presets[static_cast<std::size_t>(*view)]);
  }
  const bool again = !inspection.framed || wanted || view == CameraView::home;
  bool complete = true;
  std::vector<glm::vec3> points;
  for (std::size_t side = 0; side < (studio.ui.inspect.beside ? 2 : 1); ++side) {
    const std::shared_ptr<const InspectedShape>& shape = inspection.side(side).shape;
    complete = complete && shape && (!shape->fit || content_of(studio, side).look);
    if (!shape) continue;
    const std::vector<glm::vec3> more = inspected_points(content_of(studio, side));
    points.insert(points.end(), more.begin(), more.end());
  }
  // Until all is there that will be shown it is framed anew.
  if (again) inspection.framed = complete;
  const bool held = inspection.mouse.action != MouseAction::none || inspection.stroking;
  if (points.empty() || (!again && (!complete || held))) return;
  if (again || outgrows(inspection.seen, inspection.camera, placed.viewport(), points))
    frame_points(inspection.camera, placed.viewport(), points);
}

void draw_empty(Studio& studio) {
  const InspectSide& main = studio.inspection.main;
  const char* hint = "Click a shape in the collection: its fit is taken apart here.";
  if (!studio.collection.open()) hint = "Open a folder or a project first.";
  if (studio.ui.shape) hint = main.problem.empty() ? "Reading the shape…" : main.problem.c_str();
  empty_hint(studio, "One fit", hint);
}

// The alternations as a slider, and what they are of.
void draw_steps(Studio& studio) {
  const std::vector<ShapeFit>* steps = shown_steps(studio);
  auto& step = studio.ui.inspect.step;
  const float scale = studio.fonts.scale;
  ImGui::Dummy({4 * scale, 0});
  ImGui::SameLine();
  if (!steps || steps->empty()) {
    ImGui::AlignTextToFramePadding();
    muted_text(studio, studio.inspection.alternatives_maker.idle()
                           ? "The alternations of this fit are not known"
                           : "Trying the other templates and yaws…");
    return;
  }
  const int last = static_cast<int>(steps->size()) - 1;
  int at = step ? std::min(static_cast<int>(*step), last) : last;
  ImGui::AlignTextToFramePadding();
  muted_text(studio, "Alternations");
  tooltip(
      "From the boxes that the fit began with to its end: labels, boxes and energy after each alternation.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(std::max(60 * scale, ImGui::GetContentRegionAvail().x - 190 * scale));
  if (ImGui::SliderInt("##step", &at, 0, last, at == 0 ? "start" : "%d")) {
    step.reset();
    if (at < last) step = static_cast<std::size_t>(at);
  }
  mark_target(studio, "inspect:steps");
  ImGui::SameLine();
  char text[64];
  const double energy = (*steps)[static_cast<std::size_t>(at)].energy.total();
  std::snprintf(text, sizeof text, at == 0 ? "of %d" : "of %d   energy %.4f", last, energy);
  muted_text(studio, text);
}

}  // namespace

void draw_inspect_view(Studio& studio) {
  Inspection& inspection = studio.inspection;
  inspection.hovered.reset();
  if (!inspection.main.shape) {
    draw_empty(studio);
    return;
  }
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float steps = ImGui::GetFrameHeight() + 10 * studio.fonts.scale;
  const std::vector<PlacedSide> sides = place_sides(studio, origin, {room.x, room.y - steps});
  if (sides.empty()) return;
  frame_shapes(studio, sides.front());
  const auto has_shape = [&](const PlacedSide& each) { return inspection.side(each.index).shape != nullptr; };
  for (const PlacedSide& each : sides) {
    if (!has_shape(each)) continue;
    colour(studio, inspection.side(each.index));
    follow_mouse(studio, each);
  }
  for (const PlacedSide& each : sides) {
    if (!has_shape(each)) continue;
    draw_picture(studio, each);
    draw_inspect_overlay(studio, each.index, each.origin, each.size);
  }
  ImGui::SetCursorScreenPos({origin.x, origin.y + room.y - steps + 5 * studio.fonts.scale});
  draw_steps(studio);
}

}  // namespace archetype
