// Scales along the axes.
#include "core/fitting/starting_boxes.h"

#include "core/fitting/deformation.h"

namespace archetype {

namespace {

// A bench is three times as wide as a chair; what takes more is another kind of thing.
constexpr double largest_stretch = 3.5;

// Of the template as a whole, along its axes.
struct StretchAndShift {
  Vec3 stretch = Vec3::Ones();
  Vec3 shift = Vec3::Zero();

  void apply(Box& box) const {
    box.centre = stretch.cwiseProduct(box.centre) + shift;
    const Mat3 axes = box.orientation.toRotationMatrix();
    for (int axis = 0; axis < 3; ++axis) {
      const double grown = box.half_extent[axis] * stretch.cwiseProduct(axes.col(axis)).norm();
      box.half_extent[axis] = std::max(grown, smallest_half_extent);
    }
  }
};

// How far a box reaches from its centre along the template's axes.
Vec3 reach(const Box& box) {
  return box.orientation.toRotationMatrix().cwiseAbs() * box.half_extent;
}

Vec3 within_largest_stretch(const Vec3& stretch) {
  return stretch.cwiseMax(1 / largest_stretch).cwiseMin(largest_stretch);
}

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
    own.add(box.centre - reach(box));
    own.add(box.centre + reach(box));
  }
  StretchAndShift whole;
  whole.stretch = within_largest_stretch(shape.half_extent().cwiseQuotient(own.half_extent()));
  whole.shift = shape.centre() - whole.stretch.cwiseProduct(own.centre());
  for (Box& box : boxes) whole.apply(box);
  return boxes;
}

std::vector<Box> carried_boxes(const PartTemplate& part_template, std::span<const FittedPart> fitted) {
  std::vector<Box> boxes = mean_boxes(part_template);
  double present = 0;
  Vec3 mean_middle = Vec3::Zero();
  Vec3 found_middle = Vec3::Zero();
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!fitted[k].present) continue;
    present += 1;
    mean_middle += boxes[k].centre;
    found_middle += fitted[k].box.centre;
  }
  if (present == 0) return boxes;
  mean_middle /= present;
  found_middle /= present;
  Vec3 spread = Vec3::Zero();  // positive, since no box is flat
  Vec3 together = Vec3::Zero();
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!fitted[k].present) continue;
    const Vec3 from = boxes[k].centre - mean_middle;
    const Vec3 to = fitted[k].box.centre - found_middle;
    const Vec3 mean_reach = reach(boxes[k]);
    spread += from.cwiseAbs2() + mean_reach.cwiseAbs2();
    together += from.cwiseProduct(to) + mean_reach.cwiseProduct(reach(fitted[k].box));
  }
  StretchAndShift whole;
  whole.stretch = within_largest_stretch(together.cwiseQuotient(spread));
  whole.shift = found_middle - whole.stretch.cwiseProduct(mean_middle);
  for (Box& box : boxes) whole.apply(box);
  return boxes;
}

}  // namespace archetype
