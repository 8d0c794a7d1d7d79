// What a box that is moved, resized or turned by hand snaps to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/actions.h"
#include "ui/gizmo.h"

namespace archetype {

struct Studio;

// A plane across an axis of the template that faces of boxes snap to.
struct SnapPlane {
  int axis = 0;
  double at = 0;             // normalised units
  std::string name = {};     // "top of the shape"
  bool for_middles = false;  // the middle of a box snaps to it too: a symmetry plane
};

// The extent of the shape in view, the ground, the symmetry planes and the faces of the boxes that are not
// moving.
std::vector<SnapPlane> snap_planes(const Studio& studio, const std::vector<PlacedPart>& moving);

struct Snapped {
  Box box;
  std::vector<SnapPlane> planes = {};      // those that it snapped to
  std::optional<double> turned_degrees{};  // the angle that it snapped to
};

// `box` is what dragged_box() gave; planes nearer than `reach` (normalised units) draw it, angles of
// multiples of 15 degrees and those at which its axes are the template's within 4 degrees. It goes only where
// the handle may take it; what is resized keeps its other side, or its middle. Faces that stand askew to the
// template snap only by moving, with the outermost corner.
Snapped snapped(const Box& box, const BoxDrag& drag, const DragModifiers& modifiers,
                const std::vector<SnapPlane>& planes, double reach);

// How near is near: some pixels, at the depth of a place.
double snap_reach(const GizmoView& view, const Vec3& place);

}  // namespace archetype
