// What the view of co-aligned clouds keeps from frame to frame: the points, the camera, the pictures.
#pragma once

#include <array>
#include <functional>
#include <tuple>

#include "ui/camera_mouse.h"
#include "ui/cloud_content.h"
#include "ui/cloud_picture.h"
#include "ui/explorer_selection.h"
#include "ui/view_panes.h"

namespace archetype {

// The shapes that are asked for: fitted ones, without outliers unless they were selected one by one.
struct CloudShapes {
  std::filesystem::path project;
  std::vector<ShapeId> shapes;
  std::size_t outliers = 0;    // left out
  std::uint64_t revision = 0;  // changes with their fits
};

// Needs the window's OpenGL context when it dies.
struct CloudView {
  explicit CloudView(std::function<void()> wake) : reader(read_cloud, std::move(wake)) {}

  CloudShapes asked;
  std::chrono::steady_clock::time_point asked_at{};
  std::shared_ptr<CloudProgress> progress;      // of what is being read
  std::shared_ptr<const CloudContent> content;  // null: nothing was read yet
  std::shared_ptr<const Colours> colours;       // of the content
  // What they are of; the part in the middle of attention too.
  std::tuple<const CloudContent*, CloudColour, std::optional<PartOfTemplate>> coloured{};
  std::shared_ptr<const PointGeometry> marked;  // the points of selected and hovered shapes
  std::vector<std::uint32_t> marked_shapes;     // indices into the content's shapes, ascending

  Camera camera;
  bool framed = false;  // the first content has been brought into the picture
  std::optional<CameraFlight> flight;
  CameraMouse mouse;
  std::size_t mouse_pane = 0;            // that it is in, or was pressed in
  std::array<CloudPicture, 2> pictures;  // rigid and deformed, or the one
  std::size_t shown = 0;                 // pictures of the newest frame
  int turning = 0;                       // frames that a script still turns the camera for

  struct HoverKey {
    Camera camera;
    glm::dvec2 cursor{0, 0};
    std::size_t pane = 0;
    float blend = 0;
    const CloudContent* content = nullptr;
    friend bool operator==(const HoverKey&, const HoverKey&) = default;
  };
  std::optional<HoverKey> hover_key;         // of the newest look at what is under the cursor
  std::optional<std::size_t> hovered_point;  // its result

  CloudReader reader;
};

struct Studio;

// Those that the choice in UiState asks for.
CloudShapes wanted_shapes(const Studio& studio);
// Takes over what was read and asks for what is missing; while the view is shown, once a frame.
void follow_cloud(Studio& studio);
// The view changes by itself: points are being read, or the whole picture is still to come.
bool cloud_busy(const Studio& studio);
// The number of the shape in the cloud.
std::optional<std::uint32_t> shape_in_cloud(const CloudContent& content, ShapeId id);

}  // namespace archetype
