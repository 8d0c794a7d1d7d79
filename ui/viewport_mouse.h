// What the mouse does in the viewport.
#pragma once

#include <glm/vec2.hpp>

#include "render/scene.h"
#include "ui/gizmo.h"

namespace archetype {

struct Studio;

// The mouse over the viewport in this frame, in pixels of the viewport.
struct MouseInput {
  glm::dvec2 cursor{0, 0};
  bool over = false;  // nothing else of the window is under the cursor
  bool held =
      false;  // the button that went down over the viewport is still down, and nobody took the mouse away
  bool pressed = false;   // it went down in this frame
  int button = 0;         // which one: 0 left, 1 right, 2 middle
  bool released = false;  // it went up in this frame
  double wheel = 0;       // notches away from the user
  bool shift = false;
  bool alt = false;
  bool ctrl = false;
};

// Moves the camera, selects, drags handles. `shapes` are the handles of the selected box as drawn.
void follow_mouse(Studio& studio, const MouseInput& mouse, const Scene& scene, const GizmoView& view,
                  const std::vector<HandleShape>& shapes);

}  // namespace archetype
