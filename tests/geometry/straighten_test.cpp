#include "core/geometry/straighten.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/generate/generate.h"
#include "core/geometry/sample_shape.h"
#include "core/geometry/shape_frame.h"

using namespace archetype;

namespace {

Mat3 turn(double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitY()).toRotationMatrix();
}

// Of a box of 4 x 3 x 2, a grid on each side, some normals the other way round; or of a drum.
ShapeSamples box_samples(const Mat3& rotation) {
  ShapeSamples samples;
  const Vec3 half(2, 1.5, 1);
  for (int axis = 0; axis < 3; ++axis) {
    for (int a = -5; a <= 5; ++a) {
      for (int b = -5; b <= 5; ++b) {
        for (const int side : {-1, 1}) {
          Vec3 p;
          p[axis] = side * half[axis];
          p[(axis + 1) % 3] = 0.19 * a * half[(axis + 1) % 3];
          p[(axis + 2) % 3] = 0.19 * b * half[(axis + 2) % 3];
          samples.points.push_back(rotation * p);
          samples.normals.push_back(rotation * Vec3::Unit(axis));
        }
      }
    }
  }
  return samples;
}

ShapeSamples drum_samples() {
  ShapeSamples samples;
  for (int i = 0; i < 360; ++i) {
    samples.normals.push_back(turn(i + 0.3) * Vec3::UnitX());
    samples.points.push_back(samples.normals.back() + Vec3(0, i % 7, 0));
  }
  return samples;
}

}  // namespace

TEST_CASE("a box is turned to the nearest axes, and left where it stands nearly so") {
  for (const double degrees : {6.0, 30.0, 44.0, -44.0, -7.0}) {
    for (const int quarter : {0, 1, 2, 3}) {
      ShapeSamples samples = box_samples(turn(degrees + 90 * quarter));
      straighten(samples);
      const ShapeSamples expected = box_samples(turn(90 * quarter));
      for (std::size_t i = 0; i < samples.points.size(); ++i) {
        CHECK((samples.points[i] - expected.points[i]).norm() < 1e-9);
        CHECK((samples.normals[i] - expected.normals[i]).norm() < 1e-9);
      }
      CHECK((samples.frame.rotation - turn(-degrees)).norm() < 1e-9);
    }
  }
  for (const double degrees : {0.0, 4.5, -4.5, 93.0}) {
    ShapeSamples samples = box_samples(turn(degrees));
    straighten(samples);
    CHECK(samples.points == box_samples(turn(degrees)).points);
    CHECK(samples.frame.rotation == Mat3::Identity());
  }
}

TEST_CASE("what is square is turned from its diagonals, too") {
  for (const double degrees : {40.0, 44.5, -44.5}) {
    PolygonMesh mesh;
    mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1},
                     {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    for (Vec3& v : mesh.vertices) v = turn(degrees) * v;
    const std::vector<std::vector<std::uint32_t>> faces{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    for (const auto& face : faces) mesh.add_face(face);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const ShapeSamples samples = sample_shape(mesh, {{seed, 1}}, {});
      const double turned = std::atan2(samples.frame.rotation(0, 2), samples.frame.rotation(0, 0));
      CHECK(std::abs(std::remainder(turned * 180 / std::numbers::pi + degrees, 90)) < 2);
    }
  }
}

TEST_CASE("what is round stays as it is, and what would be less like its mirror image") {
  ShapeSamples drum = drum_samples();
  straighten(drum);
  CHECK(drum.points == drum_samples().points);
  ShapeSamples nothing;
  straighten(nothing);
  CHECK(nothing.points.empty());
  // An arrow that flies along z: all of its surface is askew.
  ShapeSamples arrow;
  for (int i = 0; i < 200; ++i) {
    for (const int side : {-1, 1}) {
      arrow.points.emplace_back(side * 0.01 * i, 0.002 * (i % 9), -0.01 * i);
      arrow.normals.push_back(Vec3(side, 0, 1).normalized());
    }
  }
  for (Vec3& p : arrow.points) p.z() += 1;
  const std::vector<Vec3> before = arrow.points;
  straighten(arrow);
  CHECK(arrow.points == before);
}

TEST_CASE("a shape has the same samples at any yaw, but for quarter turns") {
  for (const std::string family : {"chairs", "planes"}) {
    for (std::size_t index = 0; index < 6; ++index) {
      const PolygonMesh mesh = generate_shape(family, {}, index).mesh;
      PolygonMesh askew = mesh;
      for (Vec3& v : askew.vertices) v = turn(33) * v;
      const ShapeSamples straight = sample_shape(mesh, {{index, 1}}, {});
      const ShapeSamples turned = sample_shape(askew, {{index, 1}}, {});
      REQUIRE(turned.size() == straight.size());
      double least = 1e9;  // of the quarter turns, the largest distance
      for (const double quarter : {0, 90, 180, 270}) {
        double most = 0;
        for (std::size_t i = 0; i < turned.size(); ++i)
          most = std::max(most, (turn(quarter) * turned.points[i] - straight.points[i]).norm());
        least = std::min(least, most);
      }
      CHECK(least < std::sin(5 * std::numbers::pi / 180) * straight.radius);
      for (std::size_t i = 0; i < turned.size(); i += 100) {
        const Vec3 file = turned.frame.to_file(turned.points[i]);
        CHECK((file - turn(33) * straight.frame.to_file(straight.points[i])).norm() < 1e-6);
      }
    }
  }
}

TEST_CASE("the axis that points up is the one to turn about") {
  PolygonMesh mesh = generate_shape("chairs", {}, 2).mesh;
  const ShapeSamples straight = sample_shape(mesh, {{1, 2}}, {});
  for (Vec3& v : mesh.vertices) v = upright_rotation(UpAxis::z).transpose() * turn(25) * v;
  SamplingOptions options;
  options.up = UpAxis::z;
  const ShapeSamples turned = sample_shape(mesh, {{1, 2}}, options);
  double most = 0;
  for (std::size_t i = 0; i < turned.size(); ++i)
    most = std::max(most, (turned.points[i] - straight.points[i]).norm());
  CHECK(most < std::sin(5 * std::numbers::pi / 180) * straight.radius);
}
