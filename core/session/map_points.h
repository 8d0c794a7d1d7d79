// Points of one shape of a project on another one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/io/project.h"

namespace archetype {

struct MappedPoint {
  Vec3 position = Vec3::Zero();  // on the surface of the second shape, in its file coordinates
  int part = 0;                  // of the second shape's template
};

// points: file coordinates of the first shape; each counts as the nearest point of its surface. One entry
// per point, empty where that belongs to no part, or to one that the second shape lacks and that has no
// neighbour close by (see TemplateToSurface::find()). Throws FileError if
// a shape is not in the project or not labelled by a fit, InputError if its file is gone or changed.
std::vector<std::optional<MappedPoint>> map_points(const Project& project, const std::string& from,
                                                   const std::string& to, std::span<const Vec3> points);

}  // namespace archetype
