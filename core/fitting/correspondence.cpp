// Closest points.
#include "core/fitting/correspondence.h"

#include "core/geometry/kd_tree.h"

namespace archetype {

void match(std::span<const Vec3> points, std::span<const std::int16_t> labels, std::span<const Box> boxes,
           const TemplateSurface& surface, Correspondences& result) {
  result.on_template.resize(points.size());
  result.on_shape.assign(surface.local.size(), Correspondences::none);
  std::vector<std::vector<std::uint32_t>> members(boxes.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (labels[i] != null_label) members[static_cast<std::size_t>(labels[i])].push_back(i);
  }
  std::vector<Vec3> own;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (members[k].empty()) continue;
    own.clear();
    for (const auto i : members[k]) {
      result.on_template[i] = closest_on_surface(boxes[k], points[i]);
      own.push_back(points[i]);
    }
    const KdTree tree(own);
    for (auto t = surface.begins[k]; t < surface.begins[k + 1]; ++t) {
      result.on_shape[t] = members[k][tree.nearest(boxes[k].to_world(surface.local[t])).index];
    }
  }
}

}  // namespace archetype
