// Mirror images across the upright planes through the centroid.
#include "core/learning/mirror_symmetry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/kd_tree.h"

namespace archetype {

namespace {

// Mean distance of the mirrored samples to the samples, in units of R.
constexpr double same_surface = 0.02;
// Of boxes that are each other's mirror image, in units of the larger one's size, and at least in normalised
// units.
constexpr double same_box = 0.35;
constexpr double same_box_least = 0.1;

Vec3 mirrored(Vec3 p, int axis) {
  p[axis] = -p[axis];
  return p;
}

Mat3 half_axes(const Box& box) {
  const Mat3 axes = box.orientation.toRotationMatrix();
  return axes * box.half_extent.asDiagonal() * axes.transpose();
}

Eigen::Quaterniond between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.slerp(0.5, b);
}

Vec3 between(const Vec3& a, const Vec3& b) {
  return 0.5 * (a + b);
}

// Both parts become the mean of the first and the mirror image of the second, and its mirror image.
void make_pair(TemplatePart& part, TemplatePart& other, int axis) {
  const Box image = mirrored(other.mean_box(), axis);
  part.position.mean = between(part.position.mean, image.centre);
  part.scale.mean = between(part.scale.mean, image.half_extent);
  part.orientation = between(part.orientation, image.orientation);
  part.position.stddev = between(part.position.stddev, other.position.stddev);
  part.scale.stddev = between(part.scale.stddev, other.scale.stddev);
  part.existence = 0.5 * (part.existence + other.existence);
  part.must_exist = part.must_exist && other.must_exist;
  const Box back = mirrored(part.mean_box(), axis);
  other.position = {back.centre, part.position.stddev};
  other.scale = {back.half_extent, part.scale.stddev};
  other.orientation = back.orientation;
  other.existence = part.existence;
  other.must_exist = part.must_exist;
}

}  // namespace

std::array<bool, 2> mirror_planes(const ShapeSamples& samples) {
  const KdTree tree(samples.points);
  std::array<bool, 2> planes{};
  for (std::size_t plane = 0; plane < 2; ++plane) {
    double sum = 0;
    for (const Vec3& p : samples.points)
      sum += std::sqrt(tree.nearest(mirrored(p, plane == 0 ? 0 : 2)).squared_distance);
    planes[plane] = sum <= same_surface * samples.radius * static_cast<double>(samples.size());
  }
  return planes;
}

Box mirrored(const Box& box, int axis) {
  // The mirror image of a box is the mirror image of its axes; mirroring its own axis `axis` as well makes a
  // rotation of that and changes no box.
  Eigen::Quaterniond turned = box.orientation;
  for (int other = 0; other < 3; ++other) {
    if (other != axis) turned.vec()[other] = -turned.vec()[other];
  }
  return {mirrored(box.centre, axis), box.half_extent, turned};
}

Box with_nearest_axes(const Box& box) {
  const Mat3 axes = box.orientation.toRotationMatrix();
  std::array<int, 3> order{0, 1, 2};
  std::array<int, 3> best = order;
  double most = -1;
  do {
    double along = 0;
    for (int a = 0; a < 3; ++a) along += std::abs(axes(a, order[static_cast<std::size_t>(a)]));
    if (along > most + 1e-9) {
      most = along;
      best = order;
    }
  } while (std::ranges::next_permutation(order).found);
  Box result = box;
  Mat3 named;
  for (int a = 0; a < 3; ++a) {
    const int from = best[static_cast<std::size_t>(a)];
    named.col(a) = axes(a, from) < 0 ? Vec3(-axes.col(from)) : Vec3(axes.col(from));
    result.half_extent[a] = box.half_extent[from];
  }
  if (named.determinant() < 0) {
    Eigen::Index least = 0;
    named.diagonal().minCoeff(&least);
    named.col(least) *= -1;
  }
  result.orientation = Eigen::Quaterniond(named).normalized();
  return result;
}

double box_distance(const Box& a, const Box& b) {
  return std::sqrt((a.centre - b.centre).squaredNorm() + (half_axes(a) - half_axes(b)).squaredNorm());
}

void mirror_parts(PartTemplate& part_template, int axis) {
  std::vector<TemplatePart>& parts = part_template.parts;
  std::vector<bool> done(parts.size(), false);
  for (std::size_t a = 0; a < parts.size(); ++a) {
    if (done[a]) continue;
    const Box box = parts[a].mean_box();
    double least = std::max(same_box * box.half_extent.norm(), same_box_least);
    std::optional<std::size_t> partner;
    for (std::size_t b = a; b < parts.size(); ++b) {
      if (done[b]) continue;
      const double distance = box_distance(box, mirrored(parts[b].mean_box(), axis));
      if (distance >= least) continue;
      least = distance;
      partner = b;
    }
    if (!partner) continue;
    make_pair(parts[a], parts[*partner], axis);
    done[a] = done[*partner] = true;
  }
}

}  // namespace archetype
