// Boxes and ellipsoids as sorted triangles, outlines as lines.
#include "render/translucent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "render/convert.h"

namespace archetype {
namespace {

struct SortedTriangle {
  double depth = 0;
  std::array<FaceVertex, 3> corners;
};

glm::u8vec4 rgba(const Rgb& colour, float opacity) {
  return {colour[0], colour[1], colour[2],
          static_cast<std::uint8_t>(std::lround(255 * std::clamp(opacity, 0.F, 1.F)))};
}

// Each face of the box as a grid of fields, bent onto the solid that stands for it.
void add_box(const SceneBox& item, const Camera& camera, std::vector<SortedTriangle>& triangles) {
  const glm::u8vec4 colour = rgba(item.colour, item.fill);
  const int fields = item.box.solid == Solid::box ? 1 : 8;
  const auto place = [&](const Vec3& on_box) { return item.box.to_world(on_solid(item.box.solid, on_box)); };
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (int field = 0; field < fields * fields; ++field) {
        const int row = field / fields;
        const int column = field % fields;
        Vec3 middle;
        middle[axis] = side;
        middle[(axis + 1) % 3] = (2.0 * column + 1) / fields - 1;
        middle[(axis + 2) % 3] = (2.0 * row + 1) / fields - 1;
        std::array<Vec3, 4> places;
        for (std::size_t i = 0; i < 4; ++i) {
          Vec3 on_box = middle;
          on_box[(axis + 1) % 3] += (i == 0 || i == 3 ? -1.0 : 1.0) / fields;
          on_box[(axis + 2) % 3] += (i < 2 ? -1.0 : 1.0) / fields;
          places[i] = place(on_box);
        }
        const Vec3 across = (places[2] - places[0]).cross(places[3] - places[1]);
        const glm::vec3 normal(to_glm(Vec3(side * across.normalized())));
        std::array<FaceVertex, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = {glm::vec3(to_glm(places[i])), normal, colour};
        const double depth = view_depth(camera, to_glm(place(middle)));
        triangles.push_back({depth, {corners[0], corners[1], corners[2]}});
        triangles.push_back({depth, {corners[0], corners[2], corners[3]}});
      }
}

void add_ellipsoid(const SceneEllipsoid& item, const Camera& camera, std::vector<SortedTriangle>& triangles) {
  constexpr int rings = 16;
  constexpr int sectors = 32;
  const glm::u8vec4 colour = rgba(item.colour, item.opacity);
  const auto vertex = [&](int ring, int sector) {
    const double polar = glm::pi<double>() * ring / rings;
    const double turn = 2 * glm::pi<double>() * sector / sectors;
    const Vec3 unit(std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn));
    const Vec3 slope = unit.cwiseQuotient(item.axes.half_extent.cwiseMax(1e-9)).normalized();
    return FaceVertex{glm::vec3(to_glm(item.axes.to_world(unit))),
                      glm::vec3(to_glm(Vec3(item.axes.orientation * slope))), colour};
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const FaceVertex a = vertex(ring, sector);
      const FaceVertex b = vertex(ring + 1, sector);
      const FaceVertex c = vertex(ring + 1, sector + 1);
      const FaceVertex d = vertex(ring, sector + 1);
      const double depth =
          view_depth(camera, glm::dvec3(0.25F * (a.position + b.position + c.position + d.position)));
      if (ring + 1 < rings) triangles.push_back({depth, {a, b, c}});
      if (ring > 0) triangles.push_back({depth, {a, c, d}});
    }
}

// The edges of a box, bent onto the solid that stands for it: the rims of a cylinder, six fields of an
// ellipsoid.
void add_outline(const SceneBox& item, std::vector<LineInstance>& lines) {
  const int pieces = item.box.solid == Solid::box ? 1 : 12;
  const auto place = [&](const Vec3& on_box) {
    return glm::vec3(to_glm(item.box.to_world(on_solid(item.box.solid, on_box))));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int edge = 0; edge < 4; ++edge) {
      Vec3 from;
      from[axis] = -1;
      from[(axis + 1) % 3] = (edge & 1) != 0 ? 1 : -1;
      from[(axis + 2) % 3] = (edge & 2) != 0 ? 1 : -1;
      for (int piece = 0; piece < pieces; ++piece) {
        Vec3 to = from;
        to[axis] = 2.0 * (piece + 1) / pieces - 1;
        lines.push_back({place(from), place(to), rgba(item.outline.value_or(item.colour), 1),
                         item.outline_width, item.dash});
        from = to;
      }
    }
}

}  // namespace

std::vector<FaceVertex> sorted_faces(const Scene& scene, const Camera& camera) {
  std::vector<SortedTriangle> triangles;
  for (const SceneBox& box : scene.boxes)
    if (box.fill > 0) add_box(box, camera, triangles);
  for (const SceneEllipsoid& ellipsoid : scene.ellipsoids) add_ellipsoid(ellipsoid, camera, triangles);
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const SortedTriangle& a, const SortedTriangle& b) { return a.depth > b.depth; });
  std::vector<FaceVertex> vertices;
  vertices.reserve(3 * triangles.size());
  for (const SortedTriangle& triangle : triangles)
    vertices.insert(vertices.end(), triangle.corners.begin(), triangle.corners.end());
  return vertices;
}

std::vector<LineInstance> collect_lines(const Scene& scene) {
  std::vector<LineInstance> lines;
  for (const SceneBox& box : scene.boxes)
    if (box.outline_width > 0) add_outline(box, lines);
  for (const SceneLine& line : scene.lines)
    lines.push_back({line.from, line.to, rgba(line.colour, line.opacity), line.width, line.dash});
  return lines;
}

}  // namespace archetype
