// The views of the viewport: in perspective, from above, from the front and from the right; all four at once
// or one of them large. Each has a camera and a picture of its own.
#pragma once

#include <imgui.h>
#include <array>
#include <chrono>
#include <optional>
#include <vector>

#include "render/camera.h"
#include "render/renderer.h"
#include "ui/ui_state.h"
#include "ui/viewport_overlay.h"

namespace archetype {

struct Studio;
struct ViewportContent;

// A move of the camera that the eye can follow.
struct CameraFlight {
  Camera from;
  Camera to;
  std::chrono::steady_clock::time_point start;
  bool follows = false;  // a shape that outgrew the picture
};

// Moves the camera on; false once it has arrived. Its projection stays.
bool advance_flight(CameraFlight& flight, Camera& camera);
ViewPreset preset_of(CameraView view);

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
  std::optional<int> coloured_part;
  std::uint64_t display_revision = 0;
  std::shared_ptr<const PointGeometry> average;
  std::vector<std::size_t> selected;
  std::optional<std::size_t> hovered;
  friend bool operator==(const PictureKey&, const PictureKey&) = default;
};

enum class PaneKind { perspective, top, front, right };
inline constexpr std::size_t pane_count = 4;  // in the order of PaneKind

struct ViewPane {
  Camera camera;
  bool framed = false;  // the first shape has been brought into the picture
  WholeView seen;       // of the shape, when the camera stood still last
  std::optional<CameraFlight> flight;

  RenderTarget target;
  std::optional<PictureKey> drawn;  // what the target shows
  bool drawn_fine = false;
  std::chrono::steady_clock::time_point changed_at{};  // when the picture changed last
};

using ViewPanes = std::array<ViewPane, pane_count>;
// The flat ones look along their axes for good: only the one in perspective turns.
ViewPanes make_panes();

// Where a pane stands in this frame, screen units.
struct PlacedPane {
  std::size_t index = 0;
  ImVec2 origin;
  ImVec2 size;
  Viewport viewport() const { return {static_cast<int>(size.x), static_cast<int>(size.y)}; }
};
// All four, or the current one; nothing where there is no room.
std::vector<PlacedPane> place_panes(const Studio& studio, ImVec2 origin, ImVec2 size);

// Hands what commands wish for to the panes; once a frame.
void take_wishes(Studio& studio, const ViewportContent& content, const std::vector<PlacedPane>& placed);
// Moves the camera of a pane on, and brings the first shape into its picture, and each later one that is too
// large for it, unless the camera is close to a detail.
void follow_flight(Studio& studio, const ViewportContent& content, const PlacedPane& placed);

// What the corner of the pane says; the first one may be without perspective.
const char* pane_title(const Studio& studio, std::size_t pane);
// Where the name of the pane stands, in its corner.
ScreenRect pane_title_place(const Studio& studio, const PlacedPane& placed);
// A click makes the pane large, or shows all four again.
void draw_pane_title(Studio& studio, const PlacedPane& placed);

}  // namespace archetype
