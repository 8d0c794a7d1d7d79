// Closest points.
#include "core/fitting/correspondence.h"

namespace archetype {

void match(const PlacedSamples& samples, std::span<const std::int16_t> labels, std::span<const Box> boxes,
           const TemplateSurface& surface, Correspondences& result) {
  result.on_template.resize(labels.size());
  result.on_shape.resize(surface.local.size(), Correspondences::none);
  // Some sample of each part, to start a search from that has none.
  std::vector<std::uint32_t> member(boxes.size(), Correspondences::none);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == null_label) continue;
    const auto k = static_cast<std::size_t>(labels[i]);
    member[k] = i;
    result.on_template[i] = closest_on_surface(boxes[k], samples.points[i]);
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (auto t = surface.begins[k]; t < surface.begins[k + 1]; ++t) {
      std::uint32_t& match = result.on_shape[t];
      if (member[k] == Correspondences::none) {
        match = Correspondences::none;
        continue;
      }
      const Vec3 q = boxes[k].to_world(on_solid(boxes[k].solid, surface.local[t]));
      const Vec3 p = turn_quarters(q + samples.translation, samples.yaw_quarters);
      match = samples.tree->nearest_labelled(p, labels, static_cast<std::int16_t>(k),
                                             match == Correspondences::none ? member[k] : match);
    }
  }
}

}  // namespace archetype
