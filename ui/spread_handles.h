// The spread of a part by hand: dots at the ends of the ellipsoid that shows how its position varies, and of
// the dashed lines that show how its size does, as in the figures of the paper. Nothing here draws or keeps
// anything.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/model/part_template.h"
#include "ui/gizmo.h"

namespace archetype {

struct SpreadHandle {
  enum class Of { position, size };
  Of of = Of::position;
  int axis = 0;  // position: of the template; size: of the box
  int sign = 1;
  friend bool operator==(const SpreadHandle&, const SpreadHandle&) = default;
};

struct SpreadDot {
  SpreadHandle handle;
  glm::dvec2 pixel{0, 0};
};

// A standard deviation reaches from the centre along `axis` to the dot, or from the mean side to it.
// What is seen from its end has none.
std::vector<SpreadDot> spread_dots(const TemplatePart& part, const GizmoView& view);
// The dot under the cursor, with a few pixels to spare; of several the nearest.
std::optional<SpreadHandle> find_spread_handle(const std::vector<SpreadDot>& dots, const GizmoView& view,
                                               const glm::dvec2& cursor);

struct SpreadDrag {
  SpreadHandle handle;
  TemplatePart start;
  glm::dvec2 grabbed{0, 0};  // the cursor then
};
// The standard deviations (of position or size) once the cursor has come to a place. all_axes: in proportion.
Vec3 dragged_stddev(const SpreadDrag& drag, const GizmoView& view, const glm::dvec2& cursor, bool all_axes);

// The standard deviations that a handle is about.
const Vec3& stddev_of(const TemplatePart& part, SpreadHandle::Of of);

}  // namespace archetype
