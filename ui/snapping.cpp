#include "ui/snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/session/mirror_pairs.h"
#include "render/convert.h"
#include "ui/studio.h"
#include "ui/symmetry.h"
#include "ui/viewport_scene.h"

namespace archetype {
namespace {

constexpr double reach_pixels = 9;  // at scale 1
constexpr double degree = std::numbers::pi / 180;
constexpr double turn_step = 15 * degree;
constexpr double turn_reach = 4 * degree;
constexpr double straight = 1e-6;  // sine of the angle below which two directions are the same

constexpr std::array<std::array<const char*, 2>, 3> side_names{
    {{"left", "right"}, {"bottom", "top"}, {"back", "front"}}};

void add_faces(std::vector<SnapPlane>& planes, const Vec3& low, const Vec3& high, const std::string& whose) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto& names = side_names[static_cast<std::size_t>(axis)];
    planes.push_back({axis, low[axis], std::string(names[0]) + " of " + whose});
    planes.push_back({axis, high[axis], std::string(names[1]) + " of " + whose});
  }
}

// Half the room that a box takes along each axis of the template.
Vec3 room_of(const Box& box) {
  return box.orientation.toRotationMatrix().cwiseAbs() * box.half_extent;
}

struct Pull {
  double way = 0;
  const SnapPlane* plane = nullptr;
};

// The smallest way that brings one of the places onto a plane across the axis.
Pull nearest_pull(const std::vector<SnapPlane>& planes, int axis, double low, double high, double middle,
                  double reach) {
  Pull best{reach, nullptr};
  for (const SnapPlane& plane : planes) {
    if (plane.axis != axis) continue;
    const auto look = [&](double place) {
      const double way = plane.at - place;
      if (std::abs(way) < std::abs(best.way)) best = {way, &plane};
    };
    look(low);
    look(high);
    if (plane.for_middles) look(middle);
  }
  return best;
}

Vec3 axis_of(const Box& box, int k) {
  return box.orientation * Vec3(Vec3::Unit(k));
}

Snapped snap_moved(const Box& box, const BoxDrag& drag, const DragModifiers& modifiers,
                   const std::vector<SnapPlane>& planes, double reach) {
  Snapped result{box};
  const bool one = modifiers.only_axis || drag.handle.kind == HandleKind::move_axis;
  const Vec3 line = one ? axis_of(drag.start, modifiers.only_axis.value_or(drag.handle.axis)) : Vec3::Zero();
  const Vec3 normal = !one && drag.handle.kind == HandleKind::move_plane
                          ? axis_of(drag.start, drag.handle.axis)
                          : Vec3::Zero();
  const Vec3 room = room_of(box);
  Pull best_along{reach, nullptr};
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = box.centre[axis];
    const Pull pull = nearest_pull(planes, axis, middle - room[axis], middle + room[axis], middle, reach);
    if (!pull.plane) continue;
    if (one) {
      // Along a line the plane is reached after a longer way.
      if (std::abs(line[axis]) < 0.3) continue;
      const double way = pull.way / line[axis];
      if (std::abs(way) < std::abs(best_along.way)) best_along = {way, pull.plane};
    } else if (std::abs(normal[axis]) < straight) {
      result.box.centre[axis] += pull.way;
      result.planes.push_back(*pull.plane);
    }
  }
  if (best_along.plane) {
    result.box.centre += best_along.way * line;
    result.planes.push_back(*best_along.plane);
  }
  return result;
}

// A corner: the face that is nearest to a plane decides how much all three sides grow.
Snapped snap_in_proportion(const Box& box, const BoxDrag& drag, const DragModifiers& modifiers,
                           const std::vector<SnapPlane>& planes, double reach) {
  Snapped result{box};
  Pull best{reach, nullptr};
  double share = 1;
  for (int k = 0; k < 3; ++k) {
    const Vec3 out = drag.handle.side[static_cast<std::size_t>(k)] * axis_of(box, k);
    Eigen::Index axis = 0;
    if (out.cwiseAbs().maxCoeff(&axis) < 1 - straight) continue;
    const double face = box.centre[axis] + out[axis] * box.half_extent[k];
    const Pull pull = nearest_pull(planes, static_cast<int>(axis), face, face, face, std::abs(best.way));
    if (!pull.plane) continue;
    const double outwards = pull.way * (out[axis] > 0 ? 1 : -1);
    const double half = box.half_extent[k] + (modifiers.about_centre ? outwards : 0.5 * outwards);
    if (half / box.half_extent[k] * box.half_extent.minCoeff() < min_half_extent) continue;
    best = pull;
    share = half / box.half_extent[k];
  }
  if (!best.plane) return result;
  result.box.half_extent = share * box.half_extent;
  if (!modifiers.about_centre)
    for (int k = 0; k < 3; ++k)
      result.box.centre +=
          (share - 1) * box.half_extent[k] * drag.handle.side[static_cast<std::size_t>(k)] * axis_of(box, k);
  result.planes.push_back(*best.plane);
  return result;
}

Snapped snap_resized(const Box& box, const BoxDrag& drag, const DragModifiers& modifiers,
                     const std::vector<SnapPlane>& planes, double reach) {
  Snapped result{box};
  const auto& side = drag.handle.side;
  const bool in_proportion = side[0] != 0 && side[1] != 0 && side[2] != 0 && !modifiers.only_axis;
  if (in_proportion) return snap_in_proportion(box, drag, modifiers, planes, reach);
  for (int k = 0; k < 3; ++k) {
    const int sign = side[static_cast<std::size_t>(k)];
    if (sign == 0 || (modifiers.only_axis && *modifiers.only_axis != k)) continue;
    const Vec3 out = sign * axis_of(box, k);
    Eigen::Index axis = 0;
    if (out.cwiseAbs().maxCoeff(&axis) < 1 - straight) continue;
    const double face = result.box.centre[axis] + out[axis] * result.box.half_extent[k];
    const Pull pull = nearest_pull(planes, static_cast<int>(axis), face, face, face, reach);
    if (!pull.plane) continue;
    const double outwards = pull.way * (out[axis] > 0 ? 1 : -1);
    const double half = result.box.half_extent[k] + (modifiers.about_centre ? outwards : 0.5 * outwards);
    if (half < min_half_extent) continue;
    result.box.half_extent[k] = half;
    if (!modifiers.about_centre) result.box.centre += 0.5 * outwards * out;
    result.planes.push_back(*pull.plane);
  }
  return result;
}

Snapped snap_turned(const Box& box, const BoxDrag& drag, const DragModifiers& modifiers) {
  const Vec3 about = axis_of(drag.start, modifiers.only_axis.value_or(drag.handle.axis));
  const Eigen::Quaterniond turn = box.orientation * drag.start.orientation.conjugate();
  const double angle = std::remainder(2 * std::atan2(turn.vec().dot(about), turn.w()), 2 * std::numbers::pi);
  double best = std::round(angle / turn_step) * turn_step;
  // Where an axis of the box comes to lie as one of the template.
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 own = axis_of(drag.start, k);
      if (std::abs(own.dot(about)) > straight || std::abs(about[axis]) > straight) continue;
      for (const int sign : {-1, 1}) {
        const Vec3 wanted = sign * Vec3::Unit(axis);
        const double there = std::atan2(about.dot(own.cross(wanted)), own.dot(wanted));
        if (std::abs(std::remainder(there - angle, 2 * std::numbers::pi)) < std::abs(best - angle))
          best = angle + std::remainder(there - angle, 2 * std::numbers::pi);
      }
    }
  Snapped result{box};
  if (std::abs(best - angle) > turn_reach) return result;
  result.box.orientation =
      (Eigen::Quaterniond(Eigen::AngleAxisd(best, about)) * drag.start.orientation).normalized();
  result.turned_degrees = best / degree;
  return result;
}

}  // namespace

std::vector<SnapPlane> snap_planes(const Studio& studio, const std::vector<PlacedPart>& moving) {
  std::vector<SnapPlane> planes;
  const std::array<bool, 2> symmetric = symmetry_planes(studio);
  if (symmetric[0]) planes.push_back({0, 0, "symmetry plane", true});
  if (symmetric[1]) planes.push_back({2, 0, "symmetry plane", true});
  if (const auto extent = shape_extent(studio.viewport.display, studio.shape.fit.get())) {
    const Vec3 low = to_eigen(extent->first);
    add_faces(planes, low, to_eigen(extent->second), "the shape");
    std::erase_if(planes, [&](const SnapPlane& plane) { return plane.axis == 1 && plane.at == low.y(); });
    planes.push_back({1, low.y(), "ground"});
  }
  const PartTemplate* active = studio.history.committed().active_template();
  if (!active) return planes;
  for (std::size_t i = 0; i < active->parts.size(); ++i) {
    const bool moves = std::any_of(moving.begin(), moving.end(), [&](const PlacedPart& each) {
      return each.part == i || mirror_partner(*active, each.part) == i;
    });
    if (moves) continue;
    const Box box = active->parts[i].mean_box();
    add_faces(planes, box.centre - room_of(box), box.centre + room_of(box), active->parts[i].name);
  }
  return planes;
}

Snapped snapped(const Box& box, const BoxDrag& drag, const DragModifiers& modifiers,
                const std::vector<SnapPlane>& planes, double reach) {
  switch (drag.handle.kind) {
    case HandleKind::resize:
      return snap_resized(box, drag, modifiers, planes, reach);
    case HandleKind::rotate:
      return snap_turned(box, drag, modifiers);
    default:
      return snap_moved(box, drag, modifiers, planes, reach);
  }
}

double snap_reach(const GizmoView& view, const Vec3& place) {
  const double shrink =
      view.camera.orthographic ? 1 : view_depth(view.camera, to_glm(place)) / view.camera.distance;
  return reach_pixels * view.scale * pixel_size(view.camera, view.viewport) * std::max(shrink, 0.0);
}

}  // namespace archetype
