// How the map is painted: dots, pictures, rings about what is chosen; the legend and what its axes mean.
#pragma once

#include <vector>

#include "ui/shape_map_mouse.h"

namespace archetype {

struct Studio;

ImU32 map_colour(std::size_t part_template, float opacity = 1);

// As many of the points as have room for a picture of `side` screen units: those that stand first in the
// collection, wherever the view is moved to. None while too many are in sight.
std::vector<std::size_t> pictured_points(const MapState& state, const ShapeMap& map, const MapSpace& space,
                                         float side);
// Targets: "map:NAME" for each picture.
void draw_map_points(Studio& studio, const MadeMap& made, const MapSpace& space,
                     const std::vector<std::size_t>& pictured, float side);
void draw_map_outline(Studio& studio);  // of the selection that is being drawn

// A band above the map, nothing of which it covers: a dot, name and size for each template, in as many lines
// as they need, up to a third of `height`; what has no room is told at the end. A click on a
// template selects its shapes. Returns how high it is. Targets: "map:template:0" …
float draw_map_legend(Studio& studio, const MadeMap& made, ImVec2 low, float width, float height);
// What the axes mean, in a band below the map.
float axes_height(const MadeMap& made);
void draw_map_axes(Studio& studio, const MadeMap& made, ImVec2 low, float width);

}  // namespace archetype
