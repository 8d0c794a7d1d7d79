// Small linear solves.
#include "core/fitting/deformation.h"

#include <algorithm>

namespace archetype {

namespace {

// Sums of one axis of one part.
struct Normal {
  double w = 0, wu = 0, wuu = 0, wx = 0, wxu = 0;
  void add(double weight, double u, double x) {
    w += weight;
    wu += weight * u;
    wuu += weight * u * u;
    wx += weight * x;
    wxu += weight * x * u;
  }
};

}  // namespace

Vec3 rigid_step(const MatchedShape& shape, std::span<const Box> boxes) {
  const double shape_weight = 1.0 / static_cast<double>(shape.points.size());
  const double template_weight = 1.0 / static_cast<double>(shape.surface->local.size());
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (shape.labels[i] == null_label) continue;
    const Box& box = boxes[static_cast<std::size_t>(shape.labels[i])];
    sum += shape_weight * (box.to_world(shape.matches->on_template[i]) - shape.points[i]);
    weight += shape_weight;
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (auto t = shape.surface->begins[k]; t < shape.surface->begins[k + 1]; ++t) {
      const auto i = shape.matches->on_shape[t];
      if (i == Correspondences::none) break;
      sum += template_weight * (boxes[k].to_world(shape.surface->local[t]) - shape.points[i]);
      weight += template_weight;
    }
  }
  return weight > 0 ? Vec3(sum / weight) : Vec3::Zero();
}

void deformation_step(const MatchedShape& shape, const PartTemplate& part_template, const FitOptions& options,
                      std::span<Box> boxes) {
  const double scale = 1.0 / (shape.unit * shape.unit);
  const double shape_weight = scale / static_cast<double>(shape.points.size());
  const double template_weight = scale / static_cast<double>(shape.surface->local.size());
  std::vector<std::array<Normal, 3>> sums(boxes.size());
  std::vector<Mat3> axes;  // from the template's axes to the box's own
  axes.reserve(boxes.size());
  for (const Box& box : boxes) axes.emplace_back(box.orientation.conjugate().toRotationMatrix());
  const auto add = [&](std::size_t k, double weight, const Vec3& local, const Vec3& target) {
    const Vec3 x = axes[k] * target;
    for (int a = 0; a < 3; ++a) sums[k][static_cast<std::size_t>(a)].add(weight, local[a], x[a]);
  };
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (shape.labels[i] == null_label) continue;
    add(static_cast<std::size_t>(shape.labels[i]), shape_weight, shape.matches->on_template[i],
        shape.points[i]);
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (auto t = shape.surface->begins[k]; t < shape.surface->begins[k + 1]; ++t) {
      const auto i = shape.matches->on_shape[t];
      if (i == Correspondences::none) break;
      add(k, template_weight, shape.surface->local[t], shape.points[i]);
    }
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const TemplatePart& part = part_template.parts[k];
    if (sums[k][0].w == 0) {
      boxes[k] = part.mean_box();
      continue;
    }
    const Vec3 mean_position = axes[k] * part.position.mean;
    const Vec3 precision = axes[k].cwiseAbs2() * part.position.stddev.cwiseAbs2().cwiseInverse();
    // What the prior weighs falls with the deviation: the tangent of its logarithm at the box as it stands
    // is a parabola that lies above it, so that the step cannot raise the energy.
    const auto weight = [&](double deviation, double precision_) {
      return options.alpha * precision_ / (1 + precision_ * deviation * deviation / options.deformation_tail);
    };
    const Vec3 deviation = axes[k] * boxes[k].centre - mean_position;
    Vec3 position;
    for (int a = 0; a < 3; ++a) {
      const Normal& n = sums[k][static_cast<std::size_t>(a)];
      const double p = weight(deviation[a], precision[a]);
      const double s = weight(boxes[k].half_extent[a] - part.scale.mean[a],
                              1 / (part.scale.stddev[a] * part.scale.stddev[a]));
      const double a11 = n.w + p;
      const double a22 = n.wuu + s;
      const double b1 = n.wx + p * mean_position[a];
      const double b2 = n.wxu + s * part.scale.mean[a];
      double half = (a11 * b2 - n.wu * b1) / (a11 * a22 - n.wu * n.wu);
      half = std::max(half, smallest_half_extent);
      boxes[k].half_extent[a] = half;
      position[a] = (b1 - n.wu * half) / a11;  // the best position for that extent, clamped or not
    }
    boxes[k].centre = axes[k].transpose() * position;
  }
}

}  // namespace archetype
