// How the map is painted: dots, pictures, rings about what is chosen, legend and captions.
#pragma once

#include <string>
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

// A template's line of the legend.
struct LegendLine {
  std::size_t part_template = 0;
  std::string text;
  ImVec2 low;
  bool hovered = false;
};

// Its buttons, which have the mouse before the map: a click on a template selects its shapes. Targets:
// "map:template:0" …
std::vector<LegendLine> follow_map_legend(Studio& studio, const MadeMap& made, const MapSpace& space);
// The legend, and what the axes mean.
void draw_map_captions(Studio& studio, const MadeMap& made, const MapSpace& space,
                       const std::vector<LegendLine>& legend);

}  // namespace archetype
