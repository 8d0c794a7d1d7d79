// First guesses of how much parts vary.
#include "core/learning/template_from_boxes.h"

#include <algorithm>
#include <string>

#include "core/learning/mirror_symmetry.h"

namespace archetype {

namespace {

// In normalised units: a shape is about 4 wide. Templates made by hand have the like.
constexpr double position_stddev = 0.2;
constexpr double scale_stddev_share = 0.35;  // of the half extent
constexpr double smallest_scale_stddev = 0.05;
constexpr double largest_scale_stddev = 0.3;

// Of the samples; what is smaller may be missing on other shapes.
constexpr double must_exist_share = 0.25;
constexpr double first_existence = 0.9;

}  // namespace

TemplatePart part_from_box(const Box& box) {
  const Box named = with_nearest_axes(box);
  TemplatePart part;
  part.orientation = named.orientation;
  part.position = {named.centre, Vec3::Constant(position_stddev)};
  part.scale.mean = named.half_extent;
  part.scale.stddev =
      (scale_stddev_share * named.half_extent).cwiseMax(smallest_scale_stddev).cwiseMin(largest_scale_stddev);
  part.existence = first_existence;
  return part;
}

void name_parts(PartTemplate& part_template) {
  for (std::size_t k = 0; k < part_template.parts.size(); ++k) {
    part_template.parts[k].name = "part " + std::to_string(k + 1);
    part_template.parts[k].label = static_cast<int>(k);
  }
}

PartTemplate template_from_segmentation(const Segmentation& segmentation, const ShapeSamples& samples) {
  PartTemplate result;
  for (std::size_t k = 0; k < segmentation.boxes.size(); ++k) {
    TemplatePart part = part_from_box(segmentation.boxes[k]);
    const auto held = std::ranges::count(segmentation.labels, static_cast<std::int16_t>(k));
    if (static_cast<double>(held) >= must_exist_share * static_cast<double>(samples.size())) {
      part.must_exist = true;
      part.existence = 1;
    }
    result.parts.push_back(part);
  }
  const std::array<bool, 2> planes = mirror_planes(samples);
  if (planes[0]) mirror_parts(result, 0);
  if (planes[1]) mirror_parts(result, 2);
  name_parts(result);
  return result;
}

}  // namespace archetype
