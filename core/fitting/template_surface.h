// Points on the boxes of a template, fixed in box coordinates while the boxes deform.
#pragma once

#include <cstdint>
#include <vector>

#include "core/model/part_template.h"

namespace archetype {

struct TemplateSurface {
  std::vector<Vec3> local;            // on the surface of the box, each component in [-1, 1]
  std::vector<std::uint32_t> begins;  // parts + 1 offsets into local
};

// Of a box with the half extents `half`.
double surface_area(const Vec3& half);

// About `count` points over all parts by the area of their mean boxes, on a regular grid over each face;
// every part has at least 24.
TemplateSurface sample_template(const PartTemplate& part_template, int count);

// Features of the template's own boxes as if they were a shape: what to expect of a part before any shape was
// seen. Sets the features of parts that have none.
PartTemplate with_expected_features(const PartTemplate& part_template);

}  // namespace archetype
