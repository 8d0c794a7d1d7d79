// What dragging a handle makes of a box. Every function compares where the ray of the cursor meets a line or
// plane now with where the ray of the grab met it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/session/actions.h"
#include "render/convert.h"
#include "ui/gizmo.h"

namespace archetype {
namespace {

constexpr double move_step = 0.05;                   // normalised shape units
constexpr double turn_step = std::numbers::pi / 12;  // radians
constexpr double least_slant = 0.05;  // sine below which a ray and a plane do not meet usefully

struct EigenRay {
  Vec3 origin;
  Vec3 direction;
};

EigenRay ray_at(const GizmoView& view, const glm::dvec2& pixel) {
  const Ray ray = ray_through(view.camera, view.viewport, pixel);
  return {to_eigen(ray.origin), to_eigen(ray.direction)};
}

double rounded(double value, double step, bool steps) {
  return steps ? std::round(value / step) * step : value;
}

// Where the line comes closest to the ray, in units of its direction u. With w = origin - line and unit d,
// the point w + s d - t u of least length has no component along d or u; solving for t gives
//   t (u.u - (u.d)^2) = w.u - (w.d)(u.d).
std::optional<double> place_on_line(const Vec3& line, const Vec3& u, const EigenRay& ray) {
  const Vec3 w = ray.origin - line;
  const double along = u.dot(ray.direction);
  const double square = u.squaredNorm() - along * along;
  if (square < least_slant * least_slant * u.squaredNorm()) return std::nullopt;
  return (w.dot(u) - w.dot(ray.direction) * along) / square;
}

std::optional<Vec3> place_on_plane(const Vec3& point, const Vec3& normal, const EigenRay& ray) {
  const double slant = ray.direction.dot(normal);
  if (std::abs(slant) < least_slant) return std::nullopt;
  const double distance = (point - ray.origin).dot(normal) / slant;
  if (distance < 0) return std::nullopt;
  return Vec3(ray.origin + distance * ray.direction);
}

// One drag, with what all its cases need.
struct Motion {
  const BoxDrag& drag;
  const GizmoView& view;
  EigenRay before;
  EigenRay now;
  DragModifiers modifiers;
  glm::dvec2 cursor_way;  // pixels

  Vec3 axis(int k) const { return drag.start.orientation * Vec3(Vec3::Unit(k)); }

  // How far the cursor went along an axis through a point; 0 where that cannot be told.
  double along(const Vec3& point, const Vec3& direction) const {
    const auto from = place_on_line(point, direction, before);
    const auto to = place_on_line(point, direction, now);
    return from && to ? *to - *from : 0;
  }
  // The same in the plane through a point, or in that of the screen where it is seen from its edge.
  Vec3 in_plane(const Vec3& point, const Vec3& normal) const {
    const Vec3 back = to_eigen(back_axis(view.camera));
    for (const Vec3& n : {normal, back}) {
      const auto from = place_on_plane(point, n, before);
      const auto to = place_on_plane(point, n, now);
      if (from && to) return *to - *from;
    }
    return Vec3::Zero();
  }
};

Box moved(const Motion& motion) {
  Box box = motion.drag.start;
  const Handle& handle = motion.drag.handle;
  const std::optional<int> only = motion.modifiers.only_axis             ? motion.modifiers.only_axis
                                  : handle.kind == HandleKind::move_axis ? std::optional(handle.axis)
                                                                         : std::nullopt;
  Vec3 way;  // in the axes of the box
  if (only) {
    way = motion.along(box.centre, motion.axis(*only)) * Vec3::Unit(*only);
  } else {
    const bool in_plane = handle.kind == HandleKind::move_plane;
    const Vec3 normal = in_plane ? motion.axis(handle.axis) : to_eigen(back_axis(motion.view.camera));
    way = box.orientation.conjugate() * motion.in_plane(box.centre, normal);
    if (in_plane) way[handle.axis] = 0;
  }
  for (int k = 0; k < 3; ++k) way[k] = rounded(way[k], move_step, motion.modifiers.steps);
  box.centre += box.orientation * way;
  return box;
}

// How far the handle's side goes outwards along each axis, before limits.
Vec3 pulled(const Motion& motion) {
  const Box& start = motion.drag.start;
  const auto& side = motion.drag.handle.side;
  const Vec3 sides(side[0], side[1], side[2]);
  const Vec3 place = start.to_world(sides);
  const int count = static_cast<int>(sides.cwiseAbs().sum());
  if (count == 3) {
    // In proportion, along the diagonal.
    const Vec3 diagonal = start.orientation * sides.cwiseProduct(start.half_extent);
    return motion.along(place, diagonal) * start.half_extent;
  }
  if (count == 1) {
    Vec3 out = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      if (sides[k] != 0) out[k] = motion.along(place, sides[k] * motion.axis(k));
    return out;
  }
  int still = 0;
  while (sides[still] != 0) ++still;
  const Vec3 way = start.orientation.conjugate() * motion.in_plane(place, motion.axis(still));
  return way.cwiseProduct(sides);
}

Box resized(const Motion& motion) {
  const Box& start = motion.drag.start;
  const auto& side = motion.drag.handle.side;
  const Vec3 out = pulled(motion);
  const bool corner = side[0] != 0 && side[1] != 0 && side[2] != 0;
  Box box = start;
  // A corner keeps the proportions: the shortest side stops all three.
  double least_share = 0;
  for (int k = 0; k < 3; ++k) least_share = std::max(least_share, min_half_extent / start.half_extent[k]);
  Vec3 shift = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const int sign = side[static_cast<std::size_t>(k)];
    if (sign == 0 || (motion.modifiers.only_axis && *motion.modifiers.only_axis != k)) continue;
    const double step = rounded(out[k], move_step, motion.modifiers.steps && !corner);
    const double half = start.half_extent[k] + (motion.modifiers.about_centre ? step : 0.5 * step);
    const double least =
        corner && !motion.modifiers.only_axis ? least_share * start.half_extent[k] : min_half_extent;
    box.half_extent[k] = std::max({half, least, min_half_extent});  // the product may round down
    if (!motion.modifiers.about_centre) shift[k] = sign * (box.half_extent[k] - start.half_extent[k]);
  }
  box.centre += box.orientation * shift;
  return box;
}

Box turned(const Motion& motion) {
  Box box = motion.drag.start;
  const int k = motion.modifiers.only_axis.value_or(motion.drag.handle.axis);
  const Vec3 axis = motion.axis(k);
  const Vec3 from = place_on_plane(box.centre, axis, motion.before).value_or(box.centre) - box.centre;
  const Vec3 to = place_on_plane(box.centre, axis, motion.now).value_or(box.centre) - box.centre;
  double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
  if (from.isZero() || to.isZero() || std::abs(axis.dot(motion.before.direction)) < 0.2) {
    // Seen from its edge the ring is a line: the cursor turns it like a wheel, a radian for each 100 pixels.
    const Vec3 tangent = axis.cross(to_eigen(back_axis(motion.view.camera)));
    const glm::dvec2 direction(tangent.dot(to_eigen(right_axis(motion.view.camera))),
                               -tangent.dot(to_eigen(up_axis(motion.view.camera))));
    angle = glm::dot(direction, motion.cursor_way) / (100 * motion.view.scale);
  }
  angle = rounded(angle, turn_step, motion.modifiers.steps);
  box.orientation = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * box.orientation).normalized();
  return box;
}

}  // namespace

Box dragged_box(const BoxDrag& drag, const GizmoView& view, const glm::dvec2& cursor,
                const DragModifiers& modifiers) {
  const Motion motion{
      drag, view, ray_at(view, drag.grabbed), ray_at(view, cursor), modifiers, cursor - drag.grabbed};
  switch (drag.handle.kind) {
    case HandleKind::resize:
      return resized(motion);
    case HandleKind::rotate:
      return turned(motion);
    default:
      return moved(motion);
  }
}

double moved_along(const GizmoView& view, const Vec3& point, const Vec3& direction, const glm::dvec2& from,
                   const glm::dvec2& to) {
  const auto before = place_on_line(point, direction, ray_at(view, from));
  const auto now = place_on_line(point, direction, ray_at(view, to));
  return before && now ? *now - *before : 0;
}

}  // namespace archetype
