// The vector types of core: double precision, Eigen's.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace archetype {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

struct Bounds {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  bool empty() const { return (low.array() > high.array()).any(); }
  Vec3 centre() const { return 0.5 * (low + high); }
  Vec3 half_extent() const { return 0.5 * (high - low); }
};

}  // namespace archetype
