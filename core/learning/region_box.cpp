// Two boxes for each region, and round solids in both; what costs least is taken, with handicaps.
#include "core/learning/region_box.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fitting/choose_solids.h"
#include "core/geometry/kd_tree.h"
#include "core/learning/mirror_symmetry.h"

namespace archetype {

namespace {

// Half extents that a flat region does not have, in units of the spacing of the samples.
constexpr double smallest_half = 0.25;

// A turned box has to be this much cheaper: turned boxes of neighbouring parts, and of the same part on other
// shapes, agree less.
constexpr double turned_handicap = 1.25;

// A round solid has to be this much cheaper than a box, as in fits (FitOptions::round_share).
constexpr double round_handicap = 1.25;

Box box_along(const Eigen::Quaterniond& orientation, std::span<const Vec3> points, double spacing) {
  Bounds bounds;
  for (const Vec3& p : points) bounds.add(orientation.conjugate() * p);
  return {orientation * bounds.centre(), bounds.half_extent().cwiseMax(smallest_half * spacing), orientation};
}

// The solid that reaches as far as the box.
Box inscribed(Box box, Solid solid) {
  for (int axis = 0; axis < 3; ++axis) box.half_extent[axis] /= on_solid(solid, Vec3::Unit(axis))[axis];
  box.solid = solid;
  return box;
}

// About, of the surface of the solid over that of the box: of what its sides across the axis become.
double area_ratio(Solid solid, int axis) {
  return 1 / on_solid(solid, Vec3::Unit(axis))[axis];
}

// The principal axes, each called after the axis of the shape that it is nearest to, so that a region that
// stands nearly along these axes is turned little.
Eigen::Quaterniond principal_axes(std::span<const Vec3> points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - mean) * (p - mean).transpose();
  Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return with_nearest_axes({mean, Vec3::Ones(), Eigen::Quaterniond(axes)}).orientation;
}

double box_cost(const Box& box, std::span<const Vec3> points, const KdTree& tree, double unit,
                double spacing) {
  double sum = 0;
  for (const Vec3& p : points) sum += (box.to_world(closest_on_surface(box, p)) - p).squaredNorm();
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const int nu = std::max(1, static_cast<int>(std::lround(2 * box.half_extent[u] / spacing)));
    const int nv = std::max(1, static_cast<int>(std::lround(2 * box.half_extent[v] / spacing)));
    const double area = area_ratio(box.solid, axis) * 4 * box.half_extent[u] * box.half_extent[v] /
                        (nu * nv * spacing * spacing);
    for (int i = 0; i < 2 * nu * nv; ++i) {
      Vec3 local;
      local[axis] = i < nu * nv ? -1 : 1;
      local[u] = (2 * (i % nu) + 1.0) / nu - 1;
      local[v] = (2 * (i / nu % nv) + 1.0) / nv - 1;
      sum += area * tree.nearest(box.to_world(on_solid(box.solid, local))).squared_distance;
    }
  }
  return sum / (unit * unit);
}

}  // namespace

RegionBox fit_region_box(std::span<const Vec3> points, double unit, double spacing, RegionSolids solids) {
  const KdTree tree(points);
  const auto with_cost = [&](const Box& box) {
    return RegionBox{box, box_cost(box, points, tree, unit, spacing)};
  };
  const auto along = [&](const Eigen::Quaterniond& orientation) {
    RegionBox straight = with_cost(box_along(orientation, points, spacing));
    if (solids == RegionSolids::boxes) return straight;
    RegionBox best{{}, std::numeric_limits<double>::infinity()};
    for (const Solid solid : round_solids) {
      const RegionBox round = with_cost(inscribed(straight.box, solid));
      if (round.cost < best.cost) best = round;
    }
    return best.cost * round_handicap < straight.cost ? best : straight;
  };
  RegionBox upright = along(Eigen::Quaterniond::Identity());
  const Eigen::Quaterniond axes = principal_axes(points);
  // Within 8 degrees a box counts as standing along the axes.
  if (axes.angularDistance(Eigen::Quaterniond::Identity()) < 0.14) return upright;
  RegionBox turned = along(axes);
  return turned.cost * turned_handicap < upright.cost ? turned : upright;
}

}  // namespace archetype
