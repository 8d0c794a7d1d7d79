#include "core/evaluation/alike_turns.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/geometry/sample_shape.h"
#include "tests/support/made_shapes.h"

using namespace archetype;

namespace {

std::vector<int> turns_of(const PolygonMesh& mesh, const ShapeSamples& samples) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : triangulate(mesh).triangles)
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return alike_turns(samples, SurfaceSearch(triangles));
}

std::vector<int> turns_of(const std::string& family, const std::string& style) {
  GenerateOptions options;
  options.styles = {style};
  options.yaw = YawChoice::any;
  options.ups = {UpAxis::z};
  const test::MadeShape shape = test::make_shape(family, options, 3);
  return turns_of(shape.generated.mesh, shape.samples);
}

// A cuboid that is cut at its corners or not, standing on its small side.
PolygonMesh post(double width, double depth) {
  PolygonMesh mesh;
  for (const double y : {0.0, 3.0}) {
    for (const auto& [x, z] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}})
      mesh.vertices.emplace_back(5 + x * width, y, z * depth);
  }
  for (const auto& face :
       {std::array{0U, 1U, 2U, 3U}, std::array{7U, 6U, 5U, 4U}, std::array{0U, 4U, 5U, 1U},
        std::array{1U, 5U, 6U, 2U}, std::array{2U, 6U, 7U, 3U}, std::array{3U, 7U, 4U, 0U}})
    mesh.add_face(std::vector<std::uint32_t>(face.begin(), face.end()));
  return mesh;
}

}  // namespace

TEST_CASE("a surface of revolution looks the same whichever way it is turned, what has a front does not") {
  CHECK(turns_of("lamps", "pendant").size() == turn_steps);
  CHECK(turns_of("lamps", "desk") == std::vector<int>{0});
  CHECK(turns_of("chairs", "plain") == std::vector<int>{0});
  CHECK(turns_of("planes", "airliner") == std::vector<int>{0});
}

TEST_CASE("a square post looks the same every quarter turn, one with other sides every half turn") {
  const auto turns = [](const PolygonMesh& mesh) {
    return turns_of(mesh, sample_shape(mesh, {{1, 1}}, SamplingOptions{}));
  };
  CHECK(turns(post(1, 1)) == std::vector<int>{0, 6, 12, 18});
  CHECK(turns(post(1, 0.6)) == std::vector<int>{0, 12});
}

TEST_CASE("turns are about the vertical axis through the centroid, in file coordinates") {
  ShapeFrame frame;
  frame.rotation = upright_rotation(UpAxis::z);
  frame.centroid = frame.rotation * Vec3(2, 3, 4);
  frame.scale = 0.5;
  const Vec3 quarter = turn_about_up(frame, {3, 3, 9}, turn_steps / 4);
  CHECK((quarter - Vec3(2, 4, 9)).norm() < 1e-12);
  CHECK(turn_about_up(frame, {3, 3, 9}, 0) == Vec3(3, 3, 9));
}
