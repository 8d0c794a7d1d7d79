// The second step of the alternation: correspondences both ways, within each part.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fitting/template_surface.h"
#include "core/model/shape_fit.h"

namespace archetype {

struct Correspondences {
  static constexpr std::uint32_t none = UINT32_MAX;
  // For each sample the closest point on the box of its part, in box coordinates; unused for null samples.
  std::vector<Vec3> on_template;
  // For each template sample the nearest sample with the label of its part, or none where the part is absent.
  std::vector<std::uint32_t> on_shape;
};

// points: in the template's frame; labels: part index or null_label, one per point; boxes: one per part.
void match(std::span<const Vec3> points, std::span<const std::int16_t> labels, std::span<const Box> boxes,
           const TemplateSurface& surface, Correspondences& result);

}  // namespace archetype
