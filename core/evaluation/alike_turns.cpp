// Tries them all.
#include "core/evaluation/alike_turns.h"

#include <Eigen/Geometry>
#include <numbers>

namespace archetype {

namespace {

constexpr double largest_distance = 0.02;  // of R
constexpr double elsewhere = 0.05;         // share of the samples that may be farther

}  // namespace

Vec3 turn_about_up(const ShapeFrame& frame, const Vec3& p, int steps) {
  if (steps == 0) return p;
  const Eigen::AngleAxisd turn(2 * std::numbers::pi * steps / turn_steps, Vec3::UnitY());
  return frame.to_file(turn * frame.to_normalised(p));
}

std::vector<int> alike_turns(const ShapeSamples& samples, const SurfaceSearch& surface) {
  std::vector<int> turns{0};
  if (surface.empty()) return turns;
  const double reach = largest_distance * samples.radius / samples.frame.scale;
  const double allowed = elsewhere * static_cast<double>(samples.size());
  for (int steps = 1; steps < turn_steps; ++steps) {
    double missed = 0;
    for (std::size_t i = 0; i < samples.size() && missed <= allowed; ++i) {
      const Vec3 p = turn_about_up(samples.frame, samples.frame.to_file(samples.points[i]), steps);
      if (surface.nearest(p).squared_distance > reach * reach) missed += 1;
    }
    if (missed <= allowed) turns.push_back(steps);
  }
  return turns;
}

}  // namespace archetype
