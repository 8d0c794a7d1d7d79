// Scales about the middle of the bounds.
#include "core/fitting/starting_boxes.h"

#include "core/fitting/deformation.h"

namespace archetype {

namespace {

// A bench is three times as wide as a chair; what takes more is another kind of thing.
constexpr double largest_stretch = 3.5;

}  // namespace

std::vector<Box> mean_boxes(const PartTemplate& part_template) {
  std::vector<Box> boxes;
  boxes.reserve(part_template.parts.size());
  for (const TemplatePart& part : part_template.parts) boxes.push_back(part.mean_box());
  return boxes;
}

std::vector<Box> stretched_boxes(const PartTemplate& part_template, std::span<const Vec3> points) {
  std::vector<Box> boxes = mean_boxes(part_template);
  Bounds shape;
  for (const Vec3& p : points) shape.add(p);
  Bounds own;
  for (const Box& box : boxes) {
    const Vec3 reach = box.orientation.toRotationMatrix().cwiseAbs() * box.half_extent;
    own.add(box.centre - reach);
    own.add(box.centre + reach);
  }
  const Vec3 stretch = shape.half_extent()
                           .cwiseQuotient(own.half_extent())
                           .cwiseMax(1 / largest_stretch)
                           .cwiseMin(largest_stretch);
  for (Box& box : boxes) {
    box.centre = shape.centre() + stretch.cwiseProduct(box.centre - own.centre());
    const Mat3 axes = box.orientation.toRotationMatrix();
    for (int axis = 0; axis < 3; ++axis) {
      const double grown = box.half_extent[axis] * stretch.cwiseProduct(axes.col(axis)).norm();
      box.half_extent[axis] = std::max(grown, smallest_half_extent);
    }
  }
  return boxes;
}

}  // namespace archetype
