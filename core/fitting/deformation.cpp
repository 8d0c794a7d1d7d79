// Small linear solves.
#include "core/fitting/deformation.h"

#include <algorithm>
#include <cmath>

namespace archetype {

namespace {

// Sums over the correspondences of one part: u in box coordinates, x its target along the box's own axes.
struct Sums {
  double w = 0;
  Vec3 u = Vec3::Zero();
  Vec3 x = Vec3::Zero();
  Mat3 uu = Mat3::Zero();
  Mat3 xu = Mat3::Zero();
  void add(double weight, const Vec3& at, const Vec3& target) {
    w += weight;
    u += weight * at;
    x += weight * target;
    uu += weight * at * at.transpose();
    xu += weight * target * at.transpose();
  }
};

// What a prior of this precision weighs at a deviation: the tangent of the logarithm of Student's t at the
// box as it stands is a parabola that lies above it, so that the step cannot raise the energy.
double prior_weight(const FitOptions& options, double precision, double squared_deviation) {
  return options.alpha * precision / (1 + precision * squared_deviation / options.deformation_tail);
}

// The centre and half extents that minimise the energy for the box's axes as they stand.
void move_and_scale(const Sums& sums, const TemplatePart& part, const FitOptions& options, Box& box) {
  const Mat3 axes = box.orientation.conjugate().toRotationMatrix();
  const Vec3 mean_position = axes * part.position.mean;
  const Vec3 precision = axes.cwiseAbs2() * part.position.stddev.cwiseAbs2().cwiseInverse();
  const Vec3 moved = axes * box.centre - mean_position;
  Vec3 position;
  for (int a = 0; a < 3; ++a) {
    const double stddev = part.scale.stddev[a];
    const double scaled = box.half_extent[a] - part.scale.mean[a];
    const double p = prior_weight(options, precision[a], moved[a] * moved[a]);
    const double s = prior_weight(options, 1 / (stddev * stddev), scaled * scaled);
    const double a11 = sums.w + p;
    const double a22 = sums.uu(a, a) + s;
    const double b1 = sums.x[a] + p * mean_position[a];
    const double b2 = sums.xu(a, a) + s * part.scale.mean[a];
    double half = (a11 * b2 - sums.u[a] * b1) / (a11 * a22 - sums.u[a] * sums.u[a]);
    half = std::max(half, smallest_half_extent);
    box.half_extent[a] = half;
    position[a] = (b1 - sums.u[a] * half) / a11;  // the best position for that extent, clamped or not
  }
  box.centre = axes.transpose() * position;
}

// Turns the box about its centre. A point y of the box and its target x (both from the centre) part by
// const - 2 x.Ry, so the energy of a rotation R is -2 tr(R^T D) with D = sum w x y^T, and its prior. One
// Gauss-Newton step, shortened until it gains.
void turn(const Sums& sums, const TemplatePart& part, const FitOptions& options, Box& box) {
  const Mat3 axes = box.orientation.conjugate().toRotationMatrix();
  const Mat3 scale = box.half_extent.asDiagonal();
  const Mat3 D = (sums.xu - (axes * box.centre) * sums.u.transpose()) * scale;
  const Mat3 Y = scale * sums.uu * scale;
  const Eigen::Quaterniond turned = part.orientation.conjugate() * box.orientation;
  const Vec3 deviation = turn_vector(turned);
  const double precision = 1 / (options.turn_stddev * options.turn_stddev);
  const double weight = prior_weight(options, precision, deviation.squaredNorm());
  const Vec3 torque(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1));
  const Mat3 inertia = (Y.trace() + weight) * Mat3::Identity() - Y;
  Vec3 step = inertia.ldlt().solve(torque - weight * deviation);
  const auto energy = [&](const Eigen::Quaterniond& by) {
    const double squared = turn_vector(turned * by).squaredNorm();
    return options.alpha * options.deformation_tail *
               std::log1p(precision * squared / options.deformation_tail) -
           2 * by.toRotationMatrix().cwiseProduct(D).sum();
  };
  const double now = energy(Eigen::Quaterniond::Identity());
  for (int halvings = 0; halvings < 4; ++halvings, step /= 2) {
    const Eigen::Quaterniond by = turn_rotation(step);
    if (energy(by) >= now) continue;
    box.orientation = (box.orientation * by).normalized();
    return;
  }
}

}  // namespace

Vec3 turn_vector(const Eigen::Quaterniond& turn) {
  const Vec3 half = turn.w() < 0 ? Vec3(-turn.vec()) : Vec3(turn.vec());
  const double sine = half.norm();
  if (sine < 1e-9) return 2 * half;
  return half * (2 * std::atan2(sine, std::abs(turn.w())) / sine);
}

Eigen::Quaterniond turn_rotation(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle < 1e-12) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

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
      const Vec3 on_template = boxes[k].to_world(on_solid(boxes[k].solid, shape.surface->local[t]));
      sum += template_weight * (on_template - shape.points[i]);
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
  std::vector<Sums> sums(boxes.size());
  std::vector<Mat3> axes;  // from the template's axes to the box's own
  axes.reserve(boxes.size());
  for (const Box& box : boxes) axes.emplace_back(box.orientation.conjugate().toRotationMatrix());
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (shape.labels[i] == null_label) continue;
    const auto k = static_cast<std::size_t>(shape.labels[i]);
    sums[k].add(shape_weight, shape.matches->on_template[i], axes[k] * shape.points[i]);
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (auto t = shape.surface->begins[k]; t < shape.surface->begins[k + 1]; ++t) {
      const auto i = shape.matches->on_shape[t];
      if (i == Correspondences::none) break;
      const Vec3 on_template = on_solid(boxes[k].solid, shape.surface->local[t]);
      sums[k].add(template_weight, on_template, axes[k] * shape.points[i]);
    }
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const TemplatePart& part = part_template.parts[k];
    if (sums[k].w == 0) {
      boxes[k] = part.mean_box();
      continue;
    }
    move_and_scale(sums[k], part, options, boxes[k]);
    if (options.turn_stddev > 0) turn(sums[k], part, options, boxes[k]);
  }
}

}  // namespace archetype
