// Handles on the screen: their places and the search for the one under the cursor.
#include "ui/gizmo.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/convert.h"

namespace archetype {
namespace {

// Pixels on a screen of scale 1.
constexpr double arrow_length = 76;
constexpr double plane_near = 22;  // of the squares that move in a plane
constexpr double plane_far = 36;
constexpr double ring_radius = 88;
constexpr double middle_radius = 6;
constexpr double face_radius = 5.5;
constexpr double corner_radius = 4.5;
constexpr double to_spare = 5;  // by which the cursor may miss

constexpr int ring_segments = 64;

// Scene units per pixel at a place.
double unit_at(const GizmoView& view, const Vec3& place) {
  const double shrink =
      view.camera.orthographic ? 1 : view_depth(view.camera, to_glm(place)) / view.camera.distance;
  return pixel_size(view.camera, view.viewport) * shrink * view.scale;
}

Vec3 box_axis(const Box& box, int axis) {
  return box.orientation * Vec3(Vec3::Unit(axis));
}

// From a place of the scene to the eye, unit.
Vec3 to_eye(const GizmoView& view, const Vec3& place) {
  if (view.camera.orthographic) return to_eigen(back_axis(view.camera));
  return (to_eigen(eye(view.camera)) - place).normalized();
}

// Adds the shape unless a part of it lies behind the eye.
void add_shape(std::vector<HandleShape>& shapes, const GizmoView& view, HandleShape shape,
               const std::vector<Vec3>& places) {
  for (const Vec3& place : places) {
    const auto pixel = to_screen(view.camera, view.viewport, to_glm(place));
    if (!pixel) return;
    shape.points.push_back(*pixel);
  }
  shapes.push_back(std::move(shape));
}

void add_planes(std::vector<HandleShape>& shapes, const Box& box, const GizmoView& view, double unit) {
  const Vec3 towards = to_eye(view, box.centre);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(box_axis(box, axis).dot(towards)) < 0.25) continue;
    const Vec3 u = box_axis(box, (axis + 1) % 3) * unit;
    const Vec3 v = box_axis(box, (axis + 2) % 3) * unit;
    const auto corner = [&](double a, double b) { return Vec3(box.centre + a * u + b * v); };
    add_shape(shapes, view, {{HandleKind::move_plane, axis, {}}, HandleForm::square, {}, 0, false},
              {corner(plane_near, plane_near), corner(plane_far, plane_near), corner(plane_far, plane_far),
               corner(plane_near, plane_far)});
  }
}

void add_arrows(std::vector<HandleShape>& shapes, const Box& box, const GizmoView& view, double unit) {
  const Vec3 towards = to_eye(view, box.centre);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = box_axis(box, axis);
    if (std::abs(direction.dot(towards)) > 0.985) continue;
    add_shape(shapes, view, {{HandleKind::move_axis, axis, {}}, HandleForm::arrow, {}, 0, false},
              {box.centre + middle_radius * unit * direction, box.centre + arrow_length * unit * direction});
  }
}

void add_rings(std::vector<HandleShape>& shapes, const Box& box, const GizmoView& view, double unit) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 u = box_axis(box, (axis + 1) % 3) * (ring_radius * unit);
    const Vec3 v = box_axis(box, (axis + 2) % 3) * (ring_radius * unit);
    std::vector<Vec3> places;
    for (int i = 0; i < ring_segments; ++i) {
      const double turn = 2 * std::numbers::pi * i / ring_segments;
      places.emplace_back(box.centre + std::cos(turn) * u + std::sin(turn) * v);
    }
    add_shape(shapes, view, {{HandleKind::rotate, axis, {}}, HandleForm::ring, {}, 0, false}, places);
  }
}

// Dots for the sides with `count` components that are not 0: 1 faces, 2 edges, 3 corners. Those on the far
// side of the box come first, so that the near ones lie over them.
void add_resizers(std::vector<HandleShape>& shapes, const Box& box, const GizmoView& view, int count) {
  const double radius = (count == 1 ? face_radius : corner_radius) * view.scale;
  for (const bool far_side : {true, false})
    for (int code = 0; code < 27; ++code) {
      const std::array<int, 3> side{code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
      if (std::abs(side[0]) + std::abs(side[1]) + std::abs(side[2]) != count) continue;
      const Vec3 place = box.to_world(Vec3(side[0], side[1], side[2]));
      // It can be seen if one of the faces that meet there looks at the eye.
      bool seen = false;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 normal = side[static_cast<std::size_t>(axis)] * box_axis(box, axis);
        seen = seen || normal.dot(to_eye(view, place)) > 1e-6;
      }
      if (seen == far_side) continue;
      add_shape(shapes, view, {{HandleKind::resize, 0, side}, HandleForm::dot, {}, radius, !seen}, {place});
    }
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 way = b - a;
  const double square = glm::dot(way, way);
  const double t = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + t * way));
}

bool inside(const glm::dvec2& p, const std::vector<glm::dvec2>& convex) {
  int sign = 0;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const glm::dvec2 side = convex[(i + 1) % convex.size()] - convex[i];
    const glm::dvec2 to = p - convex[i];
    const double turn = side.x * to.y - side.y * to.x;
    if (turn == 0) continue;
    if (sign * turn < 0) return false;
    sign = turn > 0 ? 1 : -1;
  }
  return true;
}

bool covers(const HandleShape& shape, const glm::dvec2& cursor, double spare) {
  switch (shape.form) {
    case HandleForm::dot:
      return glm::length(cursor - shape.points[0]) <= shape.radius + spare;
    case HandleForm::square:
      return inside(cursor, shape.points);
    case HandleForm::arrow:
      return distance_to_segment(cursor, shape.points[0], shape.points[1]) <= spare + 1;
    case HandleForm::ring:
      break;
  }
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    if (distance_to_segment(cursor, shape.points[i], shape.points[(i + 1) % shape.points.size()]) <=
        spare + 1)
      return true;
  return false;
}

// Leaves out the dots of `shapes` that would lie over those of `kept`: on thin boxes they crowd.
std::vector<HandleShape> without_crowd(std::vector<HandleShape> shapes,
                                       const std::vector<HandleShape>& kept) {
  std::erase_if(shapes, [&](const HandleShape& shape) {
    return std::any_of(kept.begin(), kept.end(), [&](const HandleShape& other) {
      return covers(other, shape.points[0], shape.radius + 2);
    });
  });
  return shapes;
}

// The edges and corners, below all of `shapes` and only where they keep clear of them.
std::vector<HandleShape> with_edges_and_corners(std::vector<HandleShape> shapes, const Box& box,
                                                const GizmoView& view) {
  std::vector<HandleShape> corners;
  add_resizers(corners, box, view, 3);
  corners = without_crowd(std::move(corners), shapes);
  corners.insert(corners.end(), shapes.begin(), shapes.end());
  std::vector<HandleShape> all;
  add_resizers(all, box, view, 2);
  all = without_crowd(std::move(all), corners);
  all.insert(all.end(), corners.begin(), corners.end());
  return all;
}

}  // namespace

std::vector<HandleShape> handle_shapes(const Box& box, BoxTool tool, const GizmoView& view) {
  std::vector<HandleShape> shapes;
  const double unit = unit_at(view, box.centre);
  if (unit <= 0) return shapes;  // the box is behind the eye
  if (tool == BoxTool::rotate) {
    add_rings(shapes, box, view, unit);
    return shapes;
  }
  std::vector<HandleShape> faces;
  add_resizers(faces, box, view, 1);
  if (tool == BoxTool::scale) return with_edges_and_corners(std::move(faces), box, view);
  add_planes(shapes, box, view, unit);
  add_arrows(shapes, box, view, unit);
  add_shape(shapes, view,
            {{HandleKind::move_view, 0, {}}, HandleForm::dot, {}, middle_radius * view.scale, false},
            {box.centre});
  shapes.insert(shapes.end(), faces.begin(), faces.end());
  shapes = with_edges_and_corners(std::move(shapes), box, view);
  // What lies on the far side may be resized by the scale tool; here it would only be in the way.
  std::erase_if(shapes, [](const HandleShape& shape) {
    return shape.faint && std::ranges::count(shape.handle.side, 0) < 2;
  });
  return shapes;
}

std::optional<Handle> find_handle(const std::vector<HandleShape>& shapes, const GizmoView& view,
                                  const glm::dvec2& cursor) {
  for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape)
    if (covers(*shape, cursor, to_spare * view.scale)) return shape->handle;
  return std::nullopt;
}

}  // namespace archetype
