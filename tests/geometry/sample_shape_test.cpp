#include "core/geometry/sample_shape.h"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include "core/base/error.h"
#include "core/generate/generate.h"

using namespace archetype;

namespace {

const ContentHash hash{{1, 2}};

double mean_distance(const ShapeSamples& samples) {
  double sum = 0;
  for (const Vec3& p : samples.points) sum += p.norm();
  return sum / static_cast<double>(samples.size());
}

}  // namespace

TEST_CASE("samples are normalised, lie on their faces and go back to file coordinates") {
  for (const std::string& family : families()) {
    const PolygonMesh mesh = generate_shape(family, {}, 0).mesh;
    const ShapeSamples samples = sample_shape(mesh, hash, {});
    REQUIRE(samples.size() == 1000);
    CHECK(mean_distance(samples) == doctest::Approx(1));
    Vec3 centroid = Vec3::Zero();
    for (const Vec3& p : samples.points) centroid += p;
    CHECK(centroid.norm() / 1000 < 1e-9);
    double farthest = 0;
    for (const Vec3& a : samples.points) {
      for (const Vec3& b : samples.points) farthest = std::max(farthest, (a - b).norm());
    }
    CHECK(samples.radius == doctest::Approx(farthest));
    const Bounds box = bounds(mesh);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vec3 file = samples.frame.to_file(samples.points[i]);
      CHECK((samples.frame.to_normalised(file) - samples.points[i]).norm() < 1e-9);
      Bounds face;
      for (const auto c : mesh.face(samples.faces[i])) face.add(mesh.vertices[c]);
      const double slack = 1e-6 * box.half_extent().norm();
      CHECK((file.array() >= face.low.array() - slack).all());
      CHECK((file.array() <= face.high.array() + slack).all());
      CHECK(samples.normals[i].norm() == doctest::Approx(1));
    }
  }
}

TEST_CASE("scale and offset do not matter, the seed and the up axis do what they say") {
  const PolygonMesh mesh = generate_shape("chairs", {}, 3).mesh;
  const ShapeSamples samples = sample_shape(mesh, hash, {});
  for (const double scale : {1e-12, 1e9}) {
    PolygonMesh other = mesh;
    for (Vec3& v : other.vertices) v = scale * (v + Vec3(3, -4, 5));
    const ShapeSamples same = sample_shape(other, hash, {});
    for (std::size_t i = 0; i < samples.size(); ++i)
      CHECK((same.points[i] - samples.points[i]).norm() < 1e-5);
  }
  CHECK(sample_shape(mesh, hash, {}).points == samples.points);
  CHECK(sample_shape(mesh, hash, {.seed = 2}).points != samples.points);
  CHECK(sample_shape(mesh, {{1, 3}}, {}).points != samples.points);
  for (const UpAxis up :
       {UpAxis::y, UpAxis::z, UpAxis::x, UpAxis::minus_y, UpAxis::minus_z, UpAxis::minus_x}) {
    CHECK(upright_rotation(up).determinant() == doctest::Approx(1));
    CHECK(parse_up_axis(to_string(up)) == up);
    PolygonMesh lying = mesh;
    for (Vec3& v : lying.vertices) v = upright_rotation(up).transpose() * v;
    const ShapeSamples upright = sample_shape(lying, hash, {.up = up});
    for (std::size_t i = 0; i < samples.size(); ++i)
      CHECK((upright.points[i] - samples.points[i]).norm() < 1e-5);
  }
  CHECK_FALSE(parse_up_axis("w"));
}

TEST_CASE("a point set is thinned to points of the file") {
  PolygonMesh mesh = generate_shape("tables", {}, 0).mesh;
  const ShapeSamples surface = sample_shape(mesh, hash, {.points = 5000});
  PolygonMesh points;
  for (const Vec3& p : surface.points) points.vertices.push_back(surface.frame.to_file(p));
  const ShapeSamples samples = sample_shape(points, hash, {.points = 800});
  REQUIRE(samples.size() == 800);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    CHECK((samples.frame.to_file(samples.points[i]) - points.vertices[samples.faces[i]]).norm() < 1e-6);
  }
  CHECK(sample_shape(points, hash, {.points = 6000}).size() == 5000);
}

TEST_CASE("shapes that cannot be sampled say why") {
  PolygonMesh mesh;
  CHECK_THROWS_WITH_AS(sample_shape(mesh, hash, {}), "the shape has no points", NumericError);
  mesh.vertices = {{1, 1, 1}, {1, 1, 1}};
  CHECK_THROWS_AS(sample_shape(mesh, hash, {}), NumericError);
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.add_face(std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK_THROWS_WITH_AS(sample_shape(mesh, hash, {}), "no face of the shape has an area", NumericError);
  mesh.vertices = {{-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1.7e308, 0}};
  CHECK(sample_shape(mesh, hash, {}).size() == 1000);
}
