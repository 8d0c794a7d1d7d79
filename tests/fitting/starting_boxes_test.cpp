#include "core/fitting/starting_boxes.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace archetype;

namespace {

// A column on a foot, with a knob beside it.
PartTemplate column() {
  PartTemplate column;
  const auto add = [&](const Vec3& centre, const Vec3& half_extent) {
    TemplatePart part;
    part.position.mean = centre;
    part.scale.mean = half_extent;
    column.parts.push_back(part);
  };
  add({0, 0.5, 0}, {0.2, 0.8, 0.3});
  add({0, -0.4, 0}, {0.6, 0.1, 0.5});
  add({0.4, 0.9, 0.1}, {0.2, 0.1, 0.05});
  return column;
}

// Where every part is found on a shape that is the template stretched and moved.
std::vector<FittedPart> found(const PartTemplate& part_template, const Vec3& stretch, const Vec3& shift) {
  std::vector<FittedPart> parts;
  for (Box box : mean_boxes(part_template)) {
    box.centre = stretch.cwiseProduct(box.centre) + shift;
    box.half_extent = stretch.cwiseProduct(box.half_extent);
    parts.push_back({true, box});
  }
  return parts;
}

void check_same(const Box& a, const Box& b) {
  CHECK((a.centre - b.centre).norm() < 1e-12);
  CHECK((a.half_extent - b.half_extent).norm() < 1e-12);
}

}  // namespace

TEST_CASE("a part that was left out is carried to where the others say") {
  const PartTemplate part_template = column();
  const Vec3 stretch(0.7, 1.9, 1.1);
  const Vec3 shift(0.1, -0.6, 0.3);
  const std::vector<FittedPart> all = found(part_template, stretch, shift);
  // One part alone tells its own stretch and place along each axis.
  for (std::size_t present = 1; present < 8; ++present) {
    std::vector<FittedPart> some = all;
    for (std::size_t k = 0; k < some.size(); ++k) {
      if ((present >> k & 1) == 0) some[k] = {false, part_template.parts[k].mean_box()};
    }
    const std::vector<Box> carried = carried_boxes(part_template, some);
    for (std::size_t k = 0; k < carried.size(); ++k) check_same(carried[k], all[k].box);
  }
}

TEST_CASE("a box that stands askew is carried along the template's axes") {
  PartTemplate part_template = column();
  part_template.parts[2].orientation = Eigen::AngleAxisd(0.5, Vec3::UnitZ());
  std::vector<FittedPart> fitted = found(part_template, {2, 1, 1}, Vec3::Zero());
  fitted[2] = {false, part_template.parts[2].mean_box()};
  const Box carried = carried_boxes(part_template, fitted)[2];
  CHECK((carried.centre - Vec3(0.8, 0.9, 0.1)).norm() < 1e-12);
  // Its first axis has the share cos(0.5) along x, its second sin(0.5).
  CHECK(carried.half_extent.x() == doctest::Approx(0.2 * std::hypot(2 * std::cos(0.5), std::sin(0.5))));
  CHECK(carried.half_extent.y() == doctest::Approx(0.1 * std::hypot(2 * std::sin(0.5), std::cos(0.5))));
  CHECK(carried.half_extent.z() == doctest::Approx(0.05));
}

TEST_CASE("nothing found carries nothing, and no template is stretched without bounds") {
  const PartTemplate part_template = column();
  std::vector<FittedPart> none = found(part_template, {2, 2, 2}, {1, 1, 1});
  for (FittedPart& part : none) part.present = false;
  const std::vector<Box> carried = carried_boxes(part_template, none);
  for (std::size_t k = 0; k < carried.size(); ++k) check_same(carried[k], part_template.parts[k].mean_box());

  const std::vector<FittedPart> far = found(part_template, {50, 0.001, 1}, Vec3::Zero());
  const Box foot = carried_boxes(part_template, far)[1];
  CHECK(foot.half_extent.x() == doctest::Approx(3.5 * 0.6));
  CHECK(foot.half_extent.y() == doctest::Approx(0.1 / 3.5));
  CHECK(foot.half_extent.z() == doctest::Approx(0.5));
}
