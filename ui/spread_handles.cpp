#include "ui/spread_handles.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/session/actions.h"
#include "render/convert.h"

namespace archetype {
namespace {

constexpr double reach = 9;      // pixels around a dot, at scale 1
constexpr double least_arm = 6;  // pixels that a unit of 0.1 along the axis has to be long

Vec3 direction_of(const TemplatePart& part, const SpreadHandle& handle) {
  const Vec3 axis = handle.sign * Vec3::Unit(handle.axis);
  return handle.of == SpreadHandle::Of::position ? axis : Vec3(part.orientation * axis);
}

// Where the handle stands while its standard deviation is zero.
Vec3 root_of(const TemplatePart& part, const SpreadHandle& handle) {
  if (handle.of == SpreadHandle::Of::position) return part.position.mean;
  return part.position.mean + part.scale.mean[handle.axis] * direction_of(part, handle);
}

}  // namespace

const Vec3& stddev_of(const TemplatePart& part, SpreadHandle::Of of) {
  return of == SpreadHandle::Of::position ? part.position.stddev : part.scale.stddev;
}

std::vector<SpreadDot> spread_dots(const TemplatePart& part, const GizmoView& view) {
  std::vector<SpreadDot> dots;
  const auto pixel_of = [&](const Vec3& place) {
    return to_screen(view.camera, view.viewport, to_glm(place));
  };
  for (const auto of : {SpreadHandle::Of::size, SpreadHandle::Of::position})
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {-1, 1}) {
        const SpreadHandle handle{of, axis, sign};
        const Vec3 root = root_of(part, handle);
        const Vec3 direction = direction_of(part, handle);
        const auto from = pixel_of(root);
        const auto arm = pixel_of(root + 0.1 * direction);
        const auto end = pixel_of(root + stddev_of(part, of)[axis] * direction);
        if (!from || !arm || !end || glm::length(*arm - *from) < least_arm * view.scale) continue;
        dots.push_back({handle, *end});
      }
  return dots;
}

std::optional<SpreadHandle> find_spread_handle(const std::vector<SpreadDot>& dots, const GizmoView& view,
                                               const glm::dvec2& cursor) {
  const auto away = [&](const SpreadDot& dot) { return glm::length(dot.pixel - cursor); };
  const auto nearest = std::ranges::min_element(dots, {}, away);
  if (nearest == dots.end() || away(*nearest) > reach * view.scale) return std::nullopt;
  return nearest->handle;
}

Vec3 dragged_stddev(const SpreadDrag& drag, const GizmoView& view, const glm::dvec2& cursor, bool all_axes) {
  const Vec3 root = root_of(drag.start, drag.handle);
  const Vec3 direction = direction_of(drag.start, drag.handle);
  const Vec3& before = stddev_of(drag.start, drag.handle.of);
  const double old = before[drag.handle.axis];
  const double now =
      std::max(old + moved_along(view, root, direction, drag.grabbed, cursor), min_half_extent);
  if (all_axes) return (now / old * before).cwiseMax(min_half_extent);
  Vec3 result = before;
  result[drag.handle.axis] = now;
  return result;
}

}  // namespace archetype
