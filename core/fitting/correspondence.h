// The second step of the alternation: correspondences both ways, within each part.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fitting/template_surface.h"
#include "core/geometry/kd_tree.h"
#include "core/model/shape_fit.h"

namespace archetype {

struct Correspondences {
  static constexpr std::uint32_t none = UINT32_MAX;
  // For each sample the closest point on the box of its part, in box coordinates; unused for null samples.
  std::vector<Vec3> on_template;
  // For each template sample the nearest sample with the label of its part, or none where the part is absent.
  std::vector<std::uint32_t> on_shape;
};

// The samples of a shape, and how it stands in the template's frame.
struct PlacedSamples {
  const KdTree* tree;            // over the samples where they are, in the shape's own frame
  std::span<const Vec3> points;  // in the template's frame: turned by -yaw, then moved by -translation
  int yaw_quarters;
  Vec3 translation;
};

// labels: part index or null_label, one per sample; boxes: one per part. What `result` holds from an earlier
// call makes the search short, and changes nothing else.
void match(const PlacedSamples& samples, std::span<const std::int16_t> labels, std::span<const Box> boxes,
           const TemplateSurface& surface, Correspondences& result);

}  // namespace archetype
