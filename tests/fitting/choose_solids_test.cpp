#include "core/fitting/choose_solids.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/fitting/fit_template.h"
#include "core/geometry/features.h"

using namespace archetype;

namespace {

// About even points on a surface of half extents 0.8, 1.2 and 0.9.
std::vector<Vec3> surface(Solid solid) {
  RandomStream random(4);
  std::vector<Vec3> points;
  while (points.size() < 600) {
    Vec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (solid == Solid::ellipsoid) {
      if (p.norm() > 1) continue;
      p.normalize();
    } else if (solid == Solid::cylinder_x && random.uniform(0, 1) < 0.7) {
      const double angle = std::numbers::pi * p.y();
      p = Vec3(p.x(), std::cos(angle), std::sin(angle));
    } else if (solid == Solid::cylinder_x) {
      if (std::hypot(p.y(), p.z()) > 1) continue;
      p.x() = std::copysign(1, p.x());
    } else {
      p[static_cast<Eigen::Index>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
    }
    points.push_back(p.cwiseProduct(Vec3(0.8, 1.2, 0.9)));
  }
  return points;
}

ShapeSamples samples_of(std::vector<Vec3> points) {
  ShapeSamples samples;
  samples.radius = 2.4;
  samples.points = std::move(points);
  samples.normals.assign(samples.points.size(), Vec3::UnitY());
  samples.faces.assign(samples.points.size(), 0);
  PointFeatures features = compute_features(samples.points, feature_radius * samples.radius);
  samples.features_x = std::move(features.x);
  samples.features_z = std::move(features.z);
  return samples;
}

ShapeFit fit_of(Solid solid, double round_share) {
  PartTemplate part_template;
  part_template.parts.resize(1);
  part_template.parts[0].must_exist = true;
  part_template.parts[0].scale = {Vec3(0.7, 1.1, 0.8), Vec3::Constant(0.2)};
  FitOptions options;
  options.round_share = round_share;
  return fit_template(part_template, samples_of(surface(solid)), options).value();
}

}  // namespace

TEST_CASE("parts that are round are fitted by round solids, others stay boxes") {
  const double usual = FitOptions().round_share;
  for (const Solid solid : {Solid::ellipsoid, Solid::cylinder_x}) {
    const ShapeFit boxed = fit_of(solid, 0);
    const ShapeFit round = fit_of(solid, usual);
    CHECK(boxed.parts[0].box.solid == Solid::box);
    // A quarter turn makes the one cylinder the other; a shape as wide as deep may stand either way.
    const bool turned = round.yaw_quarters % 2 != 0 && solid == Solid::cylinder_x;
    CHECK(round.parts[0].box.solid == (turned ? Solid::cylinder_z : solid));
    CHECK(round.energy.total() < 0.8 * boxed.energy.total());
  }
  CHECK(fit_of(Solid::box, usual).parts[0].box.solid == Solid::box);
}

TEST_CASE("a round part has the extents that hold as much") {
  const Box box = fit_of(Solid::ellipsoid, 0.8).parts[0].box;
  const double volume = 8 * box.half_extent.prod();
  CHECK(volume == doctest::Approx(4 * std::numbers::pi / 3 * 0.8 * 1.2 * 0.9).epsilon(0.05));
}
