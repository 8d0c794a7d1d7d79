// The handles of the selected box: where they are on the screen, which one is under the cursor, and what
// dragging one makes of the box. Nothing here draws or keeps anything, so that tests need no window.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/geometry/box.h"
#include "render/camera.h"

namespace archetype {

enum class BoxTool { move, scale, rotate };
enum class HandleKind { move_axis, move_plane, move_view, resize, rotate };

struct Handle {
  HandleKind kind = HandleKind::move_view;
  int axis = 0;  // move_axis, rotate: of the box; move_plane: the one that stays
  std::array<int, 3> side{
      0, 0, 0};  // resize: -1, 0 or 1 per axis; one that is not 0: a face, two: an edge, three: a corner
  friend bool operator==(const Handle&, const Handle&) = default;
};

// Pixels run from the upper left corner of the viewport.
struct GizmoView {
  Camera camera;
  Viewport viewport;
  double scale = 1;  // of the screen: handles are that much larger
};

enum class HandleForm { dot, square, arrow, ring };

struct HandleShape {
  Handle handle;
  HandleForm form = HandleForm::dot;
  std::vector<glm::dvec2>
      points;          // dot: its middle; square: four corners; arrow: from and to; ring: a closed line
  double radius = 0;   // of a dot, pixels
  bool faint = false;  // on the far side of the box
};

// What the tool offers, in the order of drawing. Move: arrows, planes, the middle, the six faces and the
// edges and corners in front; scale: all faces, edges and corners; rotate: a ring for each axis. What is seen
// too much from its end is left out, and edges and corners that would lie over other handles.
std::vector<HandleShape> handle_shapes(const Box& box, BoxTool tool, const GizmoView& view);

// The handle that is drawn under the cursor, with a few pixels to spare; of several the one drawn last.
std::optional<Handle> find_handle(const std::vector<HandleShape>& shapes, const GizmoView& view,
                                  const glm::dvec2& cursor);

struct BoxDrag {
  Handle handle;
  Box start;
  glm::dvec2 grabbed{0, 0};  // the cursor then
};

struct DragModifiers {
  bool about_centre = false;       // resize: the middle stays instead of the opposite side
  bool steps = false;              // moves by multiples of 0.05 units, turns by multiples of 15 degrees
  std::optional<int> only_axis{};  // of the box, 0 to 2
};

// The box once the cursor has come to a place. Half extents stay at or above min_half_extent of
// session/actions.h, the other side of what is resized stays where it is. Depends on nothing but its
// arguments: the same place gives the same box, whatever way the cursor took.
Box dragged_box(const BoxDrag& drag, const GizmoView& view, const glm::dvec2& cursor,
                const DragModifiers& modifiers);

// How far the cursor went along a line through a point, in units of `direction`, from one pixel to another; 0
// where that cannot be told.
double moved_along(const GizmoView& view, const Vec3& point, const Vec3& direction, const glm::dvec2& from,
                   const glm::dvec2& to);

}  // namespace archetype
