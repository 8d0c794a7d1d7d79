// Scales along the axes.
#include "core/fitting/starting_boxes.h"

#include "core/fitting/deformation.h"

namespace archetype {

namespace {

// A bench is three times as wide as a chair; what takes more is another kind of thing.
constexpr double largest_stretch = 3.5;

// Scales the template as a whole along its axes, and moves it.
struct Carrying {
  Vec3 scale = Vec3::Ones();
  Vec3 shift = Vec3::Zero();

  void apply(Box& box) const {
    box.centre = scale.cwiseProduct(box.centre) + shift;
    const Mat3 axes = box.orientation.toRotationMatrix();
    for (int axis = 0; axis < 3; ++axis) {
      const double grown = box.half_extent[axis] * scale.cwiseProduct(axes.col(axis)).norm();
      box.half_extent[axis] = std::max(grown, smallest_half_extent);
    }
  }
};

// How far a box reaches from its centre along the template's axes.
Vec3 reach(const Box& box) {
  return box.orientation.toRotationMatrix().cwiseAbs() * box.half_extent;
}

Vec3 within_largest_stretch(const Vec3& scale) {
  return scale.cwiseMax(1 / largest_stretch).cwiseMin(largest_stretch);
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
  Carrying carrying;
  carrying.scale = within_largest_stretch(shape.half_extent().cwiseQuotient(own.half_extent()));
  carrying.shift = shape.centre() - carrying.scale.cwiseProduct(own.centre());
  for (Box& box : boxes) carrying.apply(box);
  return boxes;
}

std::vector<Box> carried_boxes(const PartTemplate& part_template, std::span<const FittedPart> fitted) {
  std::vector<Box> boxes = mean_boxes(part_template);
  // Sums over both ends of every part that is there, by axis: from where they are in the mean to where they
  // were found.
  double ends = 0;
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  Vec3 from_from = Vec3::Zero();
  Vec3 from_to = Vec3::Zero();
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!fitted[k].present) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 mean_end = boxes[k].centre + side * reach(boxes[k]);
      const Vec3 found_end = fitted[k].box.centre + side * reach(fitted[k].box);
      ends += 1;
      from += mean_end;
      to += found_end;
      from_from += mean_end.cwiseAbs2();
      from_to += mean_end.cwiseProduct(found_end);
    }
  }
  if (ends == 0) return boxes;
  // Positive, since no box is flat.
  const Vec3 spread = from_from - from.cwiseAbs2() / ends;
  Carrying carrying;
  carrying.scale = within_largest_stretch((from_to - from.cwiseProduct(to) / ends).cwiseQuotient(spread));
  carrying.shift = (to - carrying.scale.cwiseProduct(from)) / ends;
  for (Box& box : boxes) carrying.apply(box);
  return boxes;
}

}  // namespace archetype
