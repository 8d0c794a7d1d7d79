#include "core/geometry/features.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/base/random.h"

using namespace archetype;

TEST_CASE("a flat sheet, a rod and a ball have the features of what they are") {
  RandomStream random(4);
  std::vector<Vec3> sheet;  // facing up
  std::vector<Vec3> rod;    // along x
  std::vector<Vec3> ball;
  for (int i = 0; i < 3000; ++i) {
    sheet.emplace_back(random.uniform(-1, 1), 0, random.uniform(-1, 1));
    rod.emplace_back(random.uniform(-1, 1), 0, 0);
    ball.emplace_back(random.normal(), random.normal(), random.normal());
  }
  for (auto* points : {&sheet, &rod, &ball}) points->emplace_back(0, 0, 0);
  const Features s = compute_features(sheet, 0.5).x.back();
  CHECK(s[0] > 0.85);
  CHECK(s[1] < 1e-9);
  CHECK(s[4] > 0.85);  // faces up
  CHECK(s[5] < 1e-9);
  const Features r = compute_features(rod, 0.5).x.back();
  CHECK(r[0] < 1e-7);
  CHECK(r[2] < 1e-9);
  CHECK(r[3] == doctest::Approx(1));  // runs along a2
  CHECK(compute_features(rod, 0.5).z.back()[3] < 1e-9);
  const Features b = compute_features(ball, 3).x.back();
  CHECK(b[1] > 0.8);
}

TEST_CASE("features do not turn over with the signs of eigenvectors, and stay in [0, 1]") {
  RandomStream random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(random.normal(), random.normal() * 0.3, random.normal() * 2);
  const auto features = compute_features(points, 0.5);
  std::vector<Vec3> mirrored = points;
  for (Vec3& p : mirrored) p = -p;
  const auto opposite = compute_features(mirrored, 0.5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t f = 0; f < feature_count; ++f) {
      CHECK(features.x[i][f] == doctest::Approx(opposite.x[i][f]).epsilon(1e-6));
      CHECK(features.x[i][f] >= 0);
      CHECK(features.x[i][f] <= 1 + 1e-12);
    }
  }
}

TEST_CASE("lone and coinciding points have no local shape and no accident") {
  const std::vector<Vec3> points(3, Vec3(1, 1, 1));
  for (const auto& f : compute_features(points, 0.1).x) CHECK(f == Features{});
  CHECK(compute_features({}, 0.1).x.empty());
}

TEST_CASE("neighbourhoods are whole, however large beside the points' extent, clustered or in steps") {
  RandomStream random(6);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i)
    points.emplace_back(random.normal() * 3, random.uniform(0, 1), random.normal() * 0.01);
  for (int i = 0; i < 300; ++i)  // as far apart as the radii
    points.emplace_back(std::floor(random.uniform(0, 9)) * 0.1, std::floor(random.uniform(0, 9)) * 0.1, 0.3);
  for (const double radius : {1e-6, 0.1, 0.3, 2.0, 100.0}) {
    const PointFeatures features = compute_features(points, radius);
    for (std::size_t i = 0; i < points.size(); ++i) {
      Vec3 mean = Vec3::Zero();
      double count = 0;
      for (const Vec3& q : points)
        if ((q - points[i]).squaredNorm() <= radius * radius) ++count, mean += q - points[i];
      mean /= count;
      Mat3 covariance = Mat3::Zero();
      for (const Vec3& q : points)
        if ((q - points[i]).squaredNorm() <= radius * radius)
          covariance += (q - points[i] - mean) * (q - points[i] - mean).transpose() / count;
      const Vec3 l = Eigen::SelfAdjointEigenSolver<Mat3>(covariance, Eigen::EigenvaluesOnly).eigenvalues();
      if (l[2] < 1e-12) continue;
      CHECK(features.x[i][0] == doctest::Approx(l[1] / l[2]).epsilon(1e-6));
      CHECK(features.x[i][1] == doctest::Approx(std::max(l[0], 0.0) / l[2]).epsilon(1e-6));
    }
  }
}
