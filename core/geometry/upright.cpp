// Joint choice of up axes.
#include "core/geometry/upright.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/mirror_distances.h"

namespace archetype {

namespace {

constexpr std::size_t reference_count = 200;
constexpr std::size_t most_alike = 5;   // shapes that each shape is compared with
constexpr double oddness_weight = 0.5;  // beside profile distances, which are 0 to 2
constexpr double level_weight = 0.2;
constexpr std::array<double, up_axis_count> preference{0, 0.03, 0.06, 0.06, 0.06, 0.06};  // against each axis

// How far the centroid (the origin) lies outside the bounds of what touches the ground, in units of their
// size; 0 inside.
double instability(const std::vector<Vec3>& upright) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec3& p : upright) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  constexpr double contact_share = 0.05;
  Bounds contact;
  for (const Vec3& p : upright) {
    if (p.y() <= low + contact_share * (high - low)) contact.add(p);
  }
  const Vec3 outside = (contact.centre().cwiseAbs() - contact.half_extent()).cwiseMax(0.0);
  return std::min(std::max(outside.x(), outside.z()), 1.0);
}

// How much of the surface is level, 0 to 1: seats, table tops and
// wings are made to lie flat.
double level_share(const std::vector<Vec3>& normals, const Vec3& vertical) {
  double sum = 0;
  for (const Vec3& normal : normals) {
    const double cosine = normal.dot(vertical);
    sum += cosine * cosine * cosine * cosine;
  }
  return normals.empty() ? 0 : sum / static_cast<double>(normals.size());
}

// Mean difference, in normalised shape units.
double distance(const ShapeProfile& a, const ShapeProfile& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<float>(a.size());
}

// What shape i costs with axis `up`, given the axes of the reference shapes.
double cost(std::span<const UprightLook> looks, std::size_t i, std::size_t up,
            std::span<const std::size_t> reference, std::span<const std::size_t> ups) {
  std::array<double, most_alike> nearest;
  nearest.fill(2.0);
  std::size_t others = 0;
  for (std::size_t r = 0; r < reference.size(); ++r) {
    if (reference[r] == i) continue;
    ++others;
    const double d = distance(looks[i].profiles[up], looks[reference[r]].profiles[ups[r]]);
    const auto worst = std::max_element(nearest.begin(), nearest.end());
    if (d < *worst) *worst = d;
  }
  const std::size_t count = std::min(others, most_alike);
  std::sort(nearest.begin(), nearest.end());
  double sum = 0;
  for (std::size_t n = 0; n < count; ++n) sum += nearest[n];
  return (count > 0 ? sum / static_cast<double>(count) : 0) + oddness_weight * looks[i].oddness[up] +
         preference[up];
}

struct Choice {
  std::size_t up = 0;
  double cost = std::numeric_limits<double>::infinity();
};

Choice best_axis(std::span<const UprightLook> looks, std::size_t i, std::span<const std::size_t> reference,
                 std::span<const std::size_t> ups) {
  Choice best;
  for (std::size_t up = 0; up < up_axis_count; ++up) {
    const double c = cost(looks, i, up, reference, ups);
    if (c < best.cost) best = {up, c};
  }
  return best;
}

}  // namespace

UprightLook look_upright(const ShapeSamples& samples) {
  std::vector<Vec3> file_axes;
  file_axes.reserve(samples.size());
  for (const Vec3& p : samples.points) file_axes.emplace_back(samples.frame.rotation.transpose() * p);
  const auto uneven = mirror_distances(file_axes);
  UprightLook look;
  std::vector<Vec3> upright(samples.size());
  for (std::size_t up = 0; up < up_axis_count; ++up) {
    const Mat3 rotation = upright_rotation(static_cast<UpAxis>(up));
    for (std::size_t i = 0; i < upright.size(); ++i) upright[i] = rotation * file_axes[i];
    look.profiles[up] = shape_profile(upright);
    // The vertical planes are those across the two axes that do not point up.
    Eigen::Index vertical = 0;
    rotation.row(1).cwiseAbs().maxCoeff(&vertical);
    double symmetric = std::numeric_limits<double>::infinity();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (axis != vertical) symmetric = std::min(symmetric, uneven[static_cast<std::size_t>(axis)]);
    }
    const Vec3 upward = samples.frame.rotation * rotation.row(1).transpose();
    look.oddness[up] =
        symmetric + 0.5 * instability(upright) - level_weight * level_share(samples.normals, upward);
  }
  return look;
}

std::vector<UpAxis> decide_upright(std::span<const UprightLook> looks, const JobControl& control) {
  std::vector<std::size_t> reference;
  const std::size_t count = std::min(looks.size(), reference_count);
  for (std::size_t r = 0; r < count; ++r) reference.push_back(r * looks.size() / count);
  std::vector<std::size_t> best_ups;
  double best_cost = std::numeric_limits<double>::infinity();
  for (std::size_t start = 0; start < up_axis_count; ++start) {
    std::vector<std::size_t> ups(count, start);
    constexpr int max_sweeps = 20;
    double sum = 0;
    bool changed = true;
    for (int sweep = 0; sweep < max_sweeps && changed; ++sweep) {
      changed = false;
      sum = 0;
      for (std::size_t r = 0; r < count; ++r) {
        if (control.cancelled()) return {};
        const Choice choice = best_axis(looks, reference[r], reference, ups);
        changed |= choice.up != ups[r];
        ups[r] = choice.up;
        sum += choice.cost;
      }
    }
    if (sum < best_cost) {
      best_cost = sum;
      best_ups = ups;
    }
  }
  std::vector<UpAxis> result;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if (control.cancelled()) return {};
    result.push_back(static_cast<UpAxis>(best_axis(looks, i, reference, best_ups).up));
  }
  return result;
}

}  // namespace archetype
