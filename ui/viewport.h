// The view of the shape with its template: camera, selection and handles by mouse.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "core/session/actions.h"
#include "render/renderer.h"
#include "ui/gizmo.h"
#include "ui/shape_display.h"
#include "ui/snapping.h"
#include "ui/spread_handles.h"
#include "ui/view_panes.h"
#include "ui/viewport_scene.h"

namespace archetype {

struct Studio;

// What the mouse button that is down does.
enum class MouseAction { none, click, orbit, pan, zoom, handle, spread };  // click: until it moves

// What the viewport keeps from frame to frame. Needs the window's OpenGL context, also when it dies.
struct ViewportState {
  // `wake`: brings the window to draw a frame; called from another thread.
  ViewportState(const std::filesystem::path& shaders, std::function<void()> wake);

  ViewPanes panes = make_panes();
  std::size_t current = 0;         // the pane that the mouse is in, or was in last: the one that can be large
  std::vector<std::size_t> shown;  // panes of the newest frame
  ViewPane& pane() { return panes[current]; }
  const ViewPane& pane() const { return panes[current]; }
  bool flying() const;  // the camera of a pane that is shown

  MouseAction action = MouseAction::none;
  MouseAction after_click = MouseAction::none;  // what a click becomes once it moves
  glm::dvec2 pressed_at{0, 0};                  // pixels of the current pane
  glm::dvec2 last_cursor{0, 0};
  std::optional<BoxDrag> drag;                // while action is handle
  std::vector<PlacedPart> drag_parts;         // what it drags, as it was
  std::vector<SnapPlane> snap_planes;         // that it may snap to
  std::optional<Snapped> snapped;             // what it snaps to now
  bool drag_previewed = false;                // it has changed the document
  std::optional<Handle> handle;               // under the cursor
  std::optional<SpreadDrag> spread_drag;      // while action is spread
  bool spread_previewed = false;              // it has changed the document
  std::optional<SpreadHandle> spread_handle;  // under the cursor
  std::optional<std::size_t> hovered;         // the part whose box is under the cursor

  ShapeDisplay display;
  ShapeColours colours;
  std::uint64_t coloured_fit = 0;  // revisions that `colours` are of
  std::uint64_t coloured_display = 0;
  SurfaceColour coloured_by = SurfaceColour::part;
  std::optional<int> coloured_part;  // that keeps its colours while others are dimmed
  std::uint64_t asked_display = 0;   // shape revision of the newest request

  std::optional<AverageShape> average;
  std::optional<std::uint64_t> asked_average;  // revision of the collection of the newest request

  Renderer renderer;
  std::size_t most_moving;  // triangles, see shape_display.h

  ShapeDisplayWorker worker;
  CoarseMeshWorker coarse_worker;
  AverageWorker average_worker;
};

// Fills the current Dear ImGui window.
void draw_viewport(Studio& studio);

// Whether the viewport changes by itself: a camera flies, geometry is being made, the finer picture is still
// to come.
bool viewport_busy(const ViewportState& state, std::uint64_t shape_revision);

}  // namespace archetype
