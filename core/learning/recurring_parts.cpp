// Greedy clustering of boxes.
#include "core/learning/recurring_parts.h"

#include <algorithm>
#include <numbers>

#include "core/learning/mirror_symmetry.h"
#include "core/learning/template_from_boxes.h"

namespace archetype {

namespace {

// Boxes of one kind lie this near to their mean, as a share of its size and in normalised units.
constexpr double reach_share = 0.45;
constexpr double smallest_reach = 0.15;

// A few times is enough for means and members to agree.
constexpr int mean_shifts = 5;

// A box of a shape in the common frame.
struct FramedBox {
  std::size_t shape;
  Box box;
};

double reach_of(const Box& box) {
  return smallest_reach + reach_share * box.half_extent.norm();
}

bool is_fitted(const Box& box, const ShapeFit& fit) {
  return std::ranges::any_of(fit.parts, [&](const FittedPart& part) {
    return part.present && box_distance(with_nearest_axes(part.box), box) <= reach_of(box);
  });
}

// Those that no part of the fit stands for.
std::vector<FramedBox> free_boxes(std::span<const AlignedSegmentation> shapes) {
  std::vector<FramedBox> boxes;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const ShapeFit& fit = *shapes[s].fit;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(-fit.yaw_quarters * std::numbers::pi / 2, Vec3::UnitY()));
    for (const Box& own : shapes[s].segmentation->boxes) {
      const Box box = with_nearest_axes(
          {fit.to_template(own.centre), own.half_extent, (turn * own.orientation).normalized()});
      if (!is_fitted(box, fit)) boxes.push_back({s, box});
    }
  }
  return boxes;
}

using Members = std::vector<std::size_t>;  // indices of boxes, one of each shape at most

// The box of each shape that is nearest to `centre`, among those that are near and free.
Members members_about(const Box& centre, const std::vector<FramedBox>& boxes,
                      const std::vector<bool>& taken) {
  const double reach = reach_of(centre);
  Members members;
  double nearest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (taken[i]) continue;
    const double distance = box_distance(boxes[i].box, centre);
    if (distance > reach) continue;
    const bool same_shape = !members.empty() && boxes[members.back()].shape == boxes[i].shape;
    if (same_shape && distance >= nearest) continue;
    if (same_shape) members.pop_back();
    members.push_back(i);
    nearest = distance;
  }
  return members;
}

// Means over members, of rotations as of small ones.
Box mean_box(const Members& members, const std::vector<FramedBox>& boxes) {
  Box mean{Vec3::Zero(), Vec3::Zero(), Eigen::Quaterniond::Identity()};
  Eigen::Vector4d turned = Eigen::Vector4d::Zero();
  for (const std::size_t i : members) {
    const Box& box = boxes[i].box;
    mean.centre += box.centre;
    mean.half_extent += box.half_extent;
    turned += (box.orientation.w() < 0 ? -1 : 1) * box.orientation.coeffs();
  }
  const auto n = static_cast<double>(members.size());
  mean.centre /= n;
  mean.half_extent /= n;
  mean.orientation = Eigen::Quaterniond(turned.normalized());
  return mean;
}

TemplatePart part_of(const Members& members, const std::vector<FramedBox>& boxes, std::size_t shapes) {
  TemplatePart part = part_from_box(mean_box(members, boxes));
  Vec3 position = Vec3::Zero();
  Vec3 scale = Vec3::Zero();
  const auto n = static_cast<double>(members.size());
  for (const std::size_t i : members) {
    position += (boxes[i].box.centre - part.position.mean).cwiseAbs2() / n;
    scale += (boxes[i].box.half_extent - part.scale.mean).cwiseAbs2() / n;
  }
  // What few shapes show does not tell how much others vary: the first guess stays the least.
  part.position.stddev = position.cwiseSqrt().cwiseMax(0.75 * part.position.stddev);
  part.scale.stddev = scale.cwiseSqrt().cwiseMax(0.75 * part.scale.stddev);
  part.existence = n / static_cast<double>(shapes);
  return part;
}

}  // namespace

std::vector<TemplatePart> recurring_parts(std::span<const AlignedSegmentation> shapes,
                                          const JobControl& control) {
  const std::vector<FramedBox> boxes = free_boxes(shapes);
  std::vector<bool> taken(boxes.size(), false);
  const double least = std::max(2.0, smallest_recurrence * static_cast<double>(shapes.size()));
  std::vector<TemplatePart> parts;
  for (;;) {
    Members best;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (control.cancelled()) return {};
      if (taken[i]) continue;
      Members members = members_about(boxes[i].box, boxes, taken);
      if (members.size() > best.size()) best = std::move(members);
    }
    for (int step = 0; step < mean_shifts && !best.empty(); ++step) {
      Members next = members_about(mean_box(best, boxes), boxes, taken);
      if (next.size() < best.size() || next == best) break;
      best = std::move(next);
    }
    if (static_cast<double>(best.size()) < least) break;
    parts.push_back(part_of(best, boxes, shapes.size()));
    for (const std::size_t i : best) taken[i] = true;
  }
  return parts;
}

}  // namespace archetype
