// G, S and R: the selected boxes follow the mouse without a handle, or a typed number, until Enter or a click
// keeps what they do, or Esc or the right button puts them back.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/session/actions.h"
#include "ui/gizmo.h"

namespace archetype {

struct KeyChord;
struct MouseInput;
struct ScreenRect;
struct Studio;

// Under way.
struct TypedTransform {
  BoxTool kind = BoxTool::move;
  std::optional<int> axis;  // of the box, of the template for several boxes; nothing: free
  std::string typed;        // "-0.25"; empty: the mouse leads
  std::vector<PlacedPart> start;
  Box held;                           // around them, as they were
  Box now;                            // what became of it with the newest frame
  std::optional<glm::dvec2> grabbed;  // where the cursor was first, pixels of the viewport
  bool previewed = false;             // it has changed the document
  bool confirmed = false;             // to be kept with the next frame
};

// Needs a selected part. One that is under way goes on as another kind.
void begin_transform(Studio& studio, BoxTool kind);
void cancel_transform(Studio& studio);
// Whether the key belongs to the transform under way: a digit, sign or point, Backspace or Enter.
bool take_transform_key(Studio& studio, const KeyChord& chord);
// In each frame, instead of follow_mouse() while a transform is under way.
void follow_transform(Studio& studio, const MouseInput& mouse, const GizmoView& view);

// What it makes of the held box. Move: by units of the shape; scale: by a factor; rotate: by degrees. Numbers
// without an axis move along x, scale all sides, turn about y. `cursor` leads where no number is typed.
Box transformed_box(const TypedTransform& transform, const GizmoView& view, const glm::dvec2& cursor,
                    bool steps);
// "Move along x: 0.25"
std::string transform_text(const TypedTransform& transform, const Box& now);

// At the top of the viewport, and the axis through the boxes.
void draw_transform(Studio& studio, ImDrawList& draw, ImVec2 origin, const GizmoView& view,
                    const ScreenRect& taken);

}  // namespace archetype
