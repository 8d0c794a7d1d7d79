// The mouse on the map: pan, zoom, hover, click, and selecting by an outline.
#pragma once

#include <imgui.h>

#include <vector>

#include "ui/shape_map_state.h"
#include "ui/shape_map_store.h"

namespace archetype {

// Where the map lies in the window.
struct MapSpace {
  ImVec2 low;
  ImVec2 high;

  ImVec2 size() const { return {high.x - low.x, high.y - low.y}; }
  ImVec2 at(const MapState& state, const MapPoint& point) const {
    return {static_cast<float>((low.x + high.x) / 2 + (point.at[0] - state.x) * state.zoom),
            static_cast<float>((low.y + high.y) / 2 - (point.at[1] - state.y) * state.zoom)};
  }
  bool holds(ImVec2 p, float margin) const {
    return p.x >= low.x - margin && p.x <= high.x + margin && p.y >= low.y - margin && p.y <= high.y + margin;
  }
};

// Wheel: zoom about the cursor. Middle button, or Shift and left: pan. Left: a click selects and shows, a
// drag selects what is inside of a rectangle or lasso; with Ctrl, beside what is selected. Target: "map".
// `pictured`: the points that are drawn as pictures of so many screen units.
void follow_map_mouse(Studio& studio, const MadeMap& made, const MapSpace& space,
                      const std::vector<std::size_t>& pictured, float side);

// The shapes inside of what the tool has drawn.
std::vector<ShapeId> shapes_inside(const ShapeMap& map, const MapState& state, const MapSpace& space);

}  // namespace archetype
