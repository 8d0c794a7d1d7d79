// What every shape of every family has to be: closed solids turned outwards, labelled, marked on its surface.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/generate/generate.h"

using namespace archetype;

namespace {

constexpr std::size_t shapes_per_style = 25;

template <class Check>
void for_each_shape(GenerateOptions options, const Check& check) {
  for (const std::string& family : families()) {
    for (const std::string& style : family_names(family).styles) {
      options.styles = {style};
      for (std::size_t i = 0; i < shapes_per_style; ++i) {
        const GeneratedShape shape = generate_shape(family, options, i);
        CAPTURE(family);
        CAPTURE(style);
        CAPTURE(i);
        check(family, shape);
      }
    }
  }
}

std::size_t root(std::vector<std::size_t>& parents, std::size_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

}  // namespace

TEST_CASE("every face has a label of the family, and the main part is there") {
  for_each_shape({}, [](const std::string& family, const GeneratedShape& shape) {
    const FamilyNames names = family_names(family);
    REQUIRE(shape.labels.size() == shape.mesh.face_count());
    CHECK(shape.mesh.face_count() >= 200);
    CHECK(shape.mesh.face_count() <= 5000);
    const auto [low, high] = std::minmax_element(shape.labels.begin(), shape.labels.end());
    CHECK(*low == 0);
    CHECK(*high < static_cast<int>(names.labels.size()));
    CHECK(shape.landmarks.size() == names.landmarks.size());
  });
}

TEST_CASE("every label, landmark and style of a family occurs") {
  for (const std::string& family : families()) {
    const FamilyNames names = family_names(family);
    std::set<int> labels;
    std::set<std::size_t> landmarks;
    std::set<std::string> styles;
    for (std::size_t i = 0; i < 60; ++i) {
      const GeneratedShape shape = generate_shape(family, {}, i);
      labels.insert(shape.labels.begin(), shape.labels.end());
      styles.insert(shape.style);
      for (std::size_t k = 0; k < shape.landmarks.size(); ++k) {
        if (shape.landmarks[k].present) landmarks.insert(k);
      }
    }
    CHECK(labels.size() == names.labels.size());
    CHECK(landmarks.size() == names.landmarks.size());
    CHECK(styles.size() == names.styles.size());
  }
}

TEST_CASE("shapes are made of closed solids of one label each, turned outwards") {
  for_each_shape({}, [](const std::string&, const GeneratedShape& shape) {
    const PolygonMesh& mesh = shape.mesh;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::vector<std::size_t> parents(mesh.vertices.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      for (std::size_t k = 0; k < face.size(); ++k) {
        const std::uint32_t a = face[k];
        const std::uint32_t b = face[(k + 1) % face.size()];
        ++edges[{a, b}];
        parents[root(parents, a)] = root(parents, b);
      }
    }
    for (const auto& [edge, count] : edges) {
      REQUIRE(count == 1);
      REQUIRE(edges.count({edge.second, edge.first}) == 1);
    }
    std::map<std::size_t, double> volumes;
    std::map<std::size_t, std::set<int>> labels;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const std::size_t solid = root(parents, mesh.face(f)[0]);
      volumes[solid] += face_area_vector(mesh, f).dot(face_centre(mesh, f));
      labels[solid].insert(shape.labels[f]);
    }
    for (const auto& [solid, volume] : volumes) CHECK(volume > 0);
    for (const auto& [solid, names] : labels) CHECK(names.size() == 1);
    for (const Vec3& p : mesh.vertices) REQUIRE(p.allFinite());
  });
}

TEST_CASE("shapes stand upright on the floor and face forward") {
  for_each_shape({}, [](const std::string& family, const GeneratedShape& shape) {
    const Bounds box = bounds(shape.mesh);
    if (family != "planes") CHECK(std::abs(box.low.y()) < 0.03);
    CHECK(std::abs(box.centre().x()) < 0.05 * box.half_extent().norm());
    const auto mark = [&](const char* name) -> const Landmark& {
      const auto names = family_names(family).landmarks;
      return shape
          .landmarks[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    if (family == "chairs") {
      CHECK(mark("seat_front_left").position[0] > mark("seat_front_right").position[0]);
      CHECK(mark("seat_front_left").position[2] > mark("seat_back_left").position[2]);
    }
    if (family == "planes") CHECK(mark("nose").position[2] > mark("tail").position[2]);
  });
}

TEST_CASE("landmarks lie on the surface, also of noisy, turned and moved shapes") {
  GenerateOptions options;
  options.noise = 0.003;
  options.yaw = YawChoice::any;
  options.scale_spread = 2;
  options.offset = 3;
  options.ups = {UpAxis::z, UpAxis::minus_x};
  for_each_shape(options, [](const std::string&, const GeneratedShape& shape) {
    const Triangulation triangulation = triangulate(shape.mesh);
    const double size = 2 * bounds(shape.mesh).half_extent().norm();
    for (const Landmark& landmark : shape.landmarks) {
      if (!landmark.present) continue;
      const Vec3 p(landmark.position[0], landmark.position[1], landmark.position[2]);
      // Least volume and least overhang over the triangles: a second way to say "on the surface".
      double best = std::numeric_limits<double>::infinity();
      for (const auto& [i, j, k] : triangulation.triangles) {
        const Vec3 a = shape.mesh.vertices[i] - p;
        const Vec3 b = shape.mesh.vertices[j] - p;
        const Vec3 c = shape.mesh.vertices[k] - p;
        const double whole = (b - a).cross(c - a).norm();
        const double split = a.cross(b).norm() + b.cross(c).norm() + c.cross(a).norm();
        best = std::min(best, split - whole);
      }
      REQUIRE(best < 1e-9 * size * size);
    }
  });
}

TEST_CASE("a shape depends on seed and index only") {
  for (const std::string& family : families()) {
    GenerateOptions options;
    const GeneratedShape shape = generate_shape(family, options, 7);
    options.count = 3000;
    options.threads = 5;
    const GeneratedShape again = generate_shape(family, options, 7);
    CHECK(shape.mesh.vertices == again.mesh.vertices);
    CHECK(shape.labels == again.labels);
    CHECK(generate_shape(family, options, 8).parameters != shape.parameters);
    options.seed = 2;
    CHECK(generate_shape(family, options, 7).parameters != shape.parameters);
  }
}

TEST_CASE("options turn, lay down and scale the same shape") {
  GenerateOptions options;
  const GeneratedShape plain = generate_shape("chairs", options, 3);
  options.yaw = YawChoice::quarters;
  options.ups = {UpAxis::z};
  options.scale_spread = 1;
  std::set<double> yaws;
  for (std::size_t i = 0; i < 40; ++i) yaws.insert(generate_shape("chairs", options, i).yaw_degrees);
  CHECK(yaws == std::set<double>{0, 90, 180, 270});

  const GeneratedShape placed = generate_shape("chairs", options, 3);
  REQUIRE(placed.mesh.vertices.size() == plain.mesh.vertices.size());
  const double yaw = placed.yaw_degrees * std::acos(-1.0) / 180;
  for (std::size_t i = 0; i < plain.mesh.vertices.size(); ++i) {
    const Vec3& p = plain.mesh.vertices[i];
    const Vec3 turned(std::cos(yaw) * p.x() + std::sin(yaw) * p.z(), p.y(),
                      std::cos(yaw) * p.z() - std::sin(yaw) * p.x());
    const Vec3 upright = upright_rotation(UpAxis::z) * placed.mesh.vertices[i] / placed.scale;
    REQUIRE((upright - turned).norm() < 1e-12);
  }
}

TEST_CASE("missing parts go with their landmarks; the main part stays") {
  GenerateOptions options;
  options.missing_parts = 1;
  for_each_shape(options, [](const std::string&, const GeneratedShape& shape) {
    CHECK(std::set<int>(shape.labels.begin(), shape.labels.end()) == std::set<int>{0});
  });
  options.missing_parts = 0.3;
  int backless = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    options.styles = {"plain"};
    const GeneratedShape shape = generate_shape("chairs", options, i);
    const bool has_back = std::count(shape.labels.begin(), shape.labels.end(), 1) > 0;
    CHECK(shape.landmarks[4].present == has_back);
    backless += has_back ? 0 : 1;
  }
  CHECK(std::abs(backless / 400.0 - 0.3) < 0.08);
}

TEST_CASE("triangles keep the labels and the area") {
  GenerateOptions options;
  const GeneratedShape quads = generate_shape("planes", options, 2);
  options.triangles = true;
  const GeneratedShape cut = generate_shape("planes", options, 2);
  std::map<int, double> before;
  std::map<int, double> after;
  for (std::size_t f = 0; f < quads.mesh.face_count(); ++f)
    before[quads.labels[f]] += face_area_vector(quads.mesh, f).norm();
  for (std::size_t f = 0; f < cut.mesh.face_count(); ++f) {
    REQUIRE(cut.mesh.face(f).size() == 3);
    after[cut.labels[f]] += face_area_vector(cut.mesh, f).norm();
  }
  for (const auto& [label, area] : before) CHECK(after[label] == doctest::Approx(area).epsilon(0.02));
}

TEST_CASE("unknown names and bad options are refused with what there is") {
  CHECK_THROWS_WITH_AS(family_names("boats"),
                       "there is no family \"boats\"; there are chairs, lamps, planes, tables",
                       PreconditionError);
  GenerateOptions options;
  options.styles = {"rocking"};
  CHECK_THROWS_WITH_AS(
      generate_shape("chairs", options, 0),
      "there is no style \"rocking\" of chairs; it has plain, arms, high, bench, swivel, stool",
      PreconditionError);
  options.styles.clear();
  options.noise = std::nan("");
  CHECK_THROWS_AS(generate_shape("chairs", options, 0), PreconditionError);
  options.noise = 0;
  options.ups.clear();
  CHECK_THROWS_AS(generate_shape("chairs", options, 0), PreconditionError);
}
