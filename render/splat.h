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

}  // namespace archetype
