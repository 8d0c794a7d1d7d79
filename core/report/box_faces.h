// Boxes as they are drawn without OpenGL: in a report, in a list of the window.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/model/part_colours.h"
#include "core/model/part_template.h"

namespace archetype {

// From the front, right and above, as the window shows shapes first: x to the right, y up, z to the viewer.
Mat3 picture_view();

// Whether most of the template's shapes lack the part. Pictures of the template then show where it would be,
// by a dashed outline.
bool is_rare(const TemplatePart& part);

struct ColouredBox {
  Box box;
  Rgb colour{};
  bool rare = false;
};

struct BoxFace {
  double depth = 0;             // of its middle
  std::array<Vec3, 4> corners;  // as picture_view() has them
  Rgb colour{};                 // that of its box, in the light from above
  bool rare = false;
};

// Those that look at the viewer, the farthest first: so drawn, nearer ones cover them.
std::vector<BoxFace> visible_faces(std::span<const ColouredBox> boxes);

// The mean boxes of the template, in the colours of their parts.
std::vector<ColouredBox> coloured_boxes(const PartTemplate& part_template);

Rgb darker(const Rgb& colour, double share);  // share in [0, 1]: 0 is black

}  // namespace archetype
