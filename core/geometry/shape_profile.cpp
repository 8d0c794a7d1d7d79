// Sorted heights and distances.
#include "core/geometry/shape_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace archetype {

ShapeProfile shape_profile(std::span<const Vec3> points) {
  std::vector<std::pair<double, double>> by_height;  // height, distance from the axis
  std::vector<double> radii;
  for (const Vec3& p : points) {
    radii.push_back(std::hypot(p.x(), p.z()));
    by_height.emplace_back(p.y(), radii.back());
  }
  std::sort(by_height.begin(), by_height.end());
  std::sort(radii.begin(), radii.end());
  ShapeProfile profile{};
  for (std::size_t q = 0; q < profile_quantiles; ++q) {
    const std::size_t middle = (2 * q + 1) * by_height.size() / (2 * profile_quantiles);
    profile[q] = static_cast<float>(by_height[middle].first);
    profile[profile_quantiles + q] = static_cast<float>(radii[middle]);
    const std::size_t begin = q * by_height.size() / profile_quantiles;
    const std::size_t end = std::max((q + 1) * by_height.size() / profile_quantiles, begin + 1);
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += by_height[i].second;
    profile[2 * profile_quantiles + q] = static_cast<float>(sum / static_cast<double>(end - begin));
  }
  return profile;
}

}  // namespace archetype
