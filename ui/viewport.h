// The view of the shape with its template: camera, selection and handles by mouse.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "core/session/actions.h"
#include "render/camera.h"
#include "render/renderer.h"
#include "ui/gizmo.h"
#include "ui/shape_display.h"
#include "ui/snapping.h"
#include "ui/viewport_scene.h"

namespace archetype {

struct Studio;

// A move of the camera that the eye can follow.
struct CameraFlight {
  Camera from;
  Camera to;
  std::chrono::steady_clock::time_point start;
};

// What the mouse button that is down does.
enum class MouseAction { none, click, orbit, pan, zoom, handle };  // click: until it moves

// Everything that the picture depends on: while it stays, nothing is drawn anew.
struct PictureKey {
  Camera camera;
  PictureSize size;
  ViewOptions view;
  Backdrop backdrop = Backdrop::dark;
  bool coarse = false;
  std::uint64_t document_revision = 0;
  std::shared_ptr<const PartTemplate> looked_at;
  std::shared_ptr<const PartTemplate> compared;
  std::uint64_t fit_revision = 0;
  std::uint64_t display_revision = 0;
  std::vector<std::size_t> selected;
  std::optional<std::size_t> hovered;
  friend bool operator==(const PictureKey&, const PictureKey&) = default;
};

// What the viewport keeps from frame to frame. Needs the window's OpenGL context, also when it dies.
struct ViewportState {
  // `wake`: brings the window to draw a frame; called from another thread.
  ViewportState(const std::filesystem::path& shaders, std::function<void()> wake);

  Camera camera;
  bool framed = false;  // the first shape has been brought into the picture
  std::optional<CameraFlight> flight;

  MouseAction action = MouseAction::none;
  MouseAction after_click = MouseAction::none;  // what a click becomes once it moves
  glm::dvec2 pressed_at{0, 0};                  // pixels of the viewport
  glm::dvec2 last_cursor{0, 0};
  std::optional<BoxDrag> drag;         // while action is handle
  std::vector<PlacedPart> drag_parts;  // what it drags, as it was
  std::vector<SnapPlane> snap_planes;  // that it may snap to
  std::optional<Snapped> snapped;      // what it snaps to now
  bool drag_previewed = false;         // it has changed the document
  std::optional<Handle> handle;        // under the cursor
  std::optional<std::size_t> hovered;  // the part whose box is under the cursor

  ShapeDisplay display;
  ShapeColours colours;
  std::uint64_t coloured_fit = 0;  // revisions that `colours` are of
  std::uint64_t coloured_display = 0;
  std::uint64_t asked_display = 0;  // shape revision of the newest request

  Renderer renderer;
  RenderTarget target;
  std::optional<PictureKey> drawn;  // what the target shows
  bool drawn_fine = false;
  std::chrono::steady_clock::time_point changed_at{};  // when the picture changed last

  ShapeDisplayWorker worker;
  CoarseMeshWorker coarse_worker;
};

// Fills the current Dear ImGui window.
void draw_viewport(Studio& studio);

// Whether the viewport changes by itself: a camera flies, geometry is being made, the finer picture is still
// to come.
bool viewport_busy(const ViewportState& state, std::uint64_t shape_revision);

}  // namespace archetype
