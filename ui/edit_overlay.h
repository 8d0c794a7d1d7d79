// What is drawn over the viewport while boxes are edited: what they snap to, the axis they keep to, the
// numbers.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/gizmo.h"
#include "ui/snapping.h"
#include "ui/viewport_overlay.h"

namespace archetype {

// `origin` is the upper left corner of the viewport. Through a place, as far as the viewport goes.
void draw_axis_line(ImDrawList& draw, ImVec2 origin, const Vec3& place, const Vec3& direction, int axis,
                    const GizmoView& view);
// The planes as outlines about the box, with their names.
void draw_snapped(ImDrawList& draw, ImVec2 origin, const Snapped& snapped, const GizmoView& view);
// A strip at the top, to the left of `taken`: what goes on, and muted what to do.
void draw_strip(ImDrawList& draw, ImVec2 origin, const GizmoView& view, const ScreenRect& taken,
                const std::string& text, const std::string& hint);
// Where it stands: in the middle, or as far to the left as it must.
ScreenRect strip_place(ImVec2 origin, const GizmoView& view, const ScreenRect& taken, ImVec2 text_size);

}  // namespace archetype
