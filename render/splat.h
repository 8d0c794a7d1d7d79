// How large points are drawn: drawing and picking have to agree.
#pragma once

#include <algorithm>

#include "render/scene.h"

namespace archetype {

inline constexpr float least_splat_diameter = 2;  // pixels
inline constexpr float largest_splat_diameter = 64;

// In scene units.
inline float splat_radius(const ScenePoints& points) {
  return points.radius > 0 ? points.radius : 0.5F * points.geometry->spacing;
}

// One past the last point that is drawn.
inline std::size_t last_drawn(const ScenePoints& points) {
  const std::size_t count = points.geometry->positions.size();
  const std::size_t first = std::min(points.first, count);
  return first + std::min(points.most, count - first);
}

// Where a point is drawn, before the transform.
inline glm::vec3 drawn_position(const ScenePoints& points, std::size_t i) {
  const glm::vec3 at = points.geometry->positions[i];
  if (points.geometry->moved.empty()) return at;
  return at + points.blend * (points.geometry->moved[i] - at);
}

}  // namespace archetype
