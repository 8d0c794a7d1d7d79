// What the window shows and how: plain data, not undoable. What shall last is kept in the settings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/io/project.h"

namespace archetype {

enum class SurfaceColour { part, plain };

// The switches of the View menu.
struct ViewOptions {
  bool surface = true;
  bool wireframe = false;
  bool points = false;        // the samples
  bool mean_boxes = true;     // of the template: what is edited
  bool fitted_boxes = false;  // as deformed to the shape in view
  bool part_names = true;
  bool ground = true;
  bool orthographic = false;
  SurfaceColour colour = SurfaceColour::part;
  friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

enum class CameraView { front, back, left, right, top, bottom, home };
enum class BoxTool { move, scale, rotate };
enum class Navigation { archetype, blender, maya };  // which buttons orbit, pan and zoom

struct UiState {
  std::optional<ShapeId> shape;     // the shape in view
  std::optional<std::size_t> part;  // the selected part of the active template
  ViewOptions view;
  BoxTool tool = BoxTool::move;
  std::optional<int> drag_axis;  // of the box, 0 to 2: the drag under way keeps to it (X, Y, Z)
  Navigation navigation = Navigation::archetype;
  // Wishes of commands to the viewport, which clears them once it has followed.
  std::optional<CameraView> wanted_view;
  bool wanted_frame = false;  // frame the selected box, or the shape where none is selected
};

}  // namespace archetype
