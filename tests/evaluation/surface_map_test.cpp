#include "core/evaluation/surface_map.h"

#include <doctest/doctest.h>

#include "core/base/error.h"

using namespace archetype;

namespace {

void add_cuboid(PolygonMesh& mesh, const Vec3& low, const Vec3& high) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  for (const auto& face :
       {std::array{0U, 2U, 3U, 1U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U},
        std::array{2U, 6U, 7U, 3U}, std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}}) {
    std::vector<std::uint32_t> corners;
    for (const auto corner : face) corners.push_back(first + corner);
    mesh.add_face(corners);
  }
}

// A seat (part 0) and a back (part 1) that stands on its far edge: two cuboids, and the fit that says so.
struct Chair {
  PolygonMesh mesh;
  ShapeFrame frame;
  ShapeFit fit;
  std::vector<std::int16_t> labels;

  Chair(double width, double back_height, int yaw) {
    const std::array<Box, 2> boxes{
        Box{{0, 0, 0}, {width, 0.1, 0.5}, Eigen::Quaterniond::Identity()},
        Box{{0, 0.1 + back_height, -0.4}, {width, back_height, 0.1}, Eigen::Quaterniond::Identity()}};
    for (const Box& box : boxes) add_cuboid(mesh, box.centre - box.half_extent, box.centre + box.half_extent);
    fit.yaw_quarters = yaw;
    fit.translation = {0.1, -0.2, 0.3};
    frame.scale = 0.5;
    frame.centroid = {3, 4, 5};
    frame.rotation = upright_rotation(UpAxis::z);
    for (Vec3& p : mesh.vertices) p = to_file(p);
    fit.parts = {{true, boxes[0]}, {true, boxes[1]}};
    labels.assign(6, 0);
    labels.resize(12, 1);
  }
  LabelledSurface surface() const { return {mesh, frame, fit, labels}; }
  Vec3 to_file(const Vec3& in_template) const { return frame.to_file(fit.to_shape(in_template)); }
};

PartTemplate chair_template() {
  PartTemplate result;
  result.parts.resize(2);
  result.parts[0].name = "seat";
  result.parts[0].scale.mean = {0.5, 0.1, 0.5};
  result.parts[1].name = "back";
  result.parts[1].position.mean = {0, 0.5, -0.4};
  result.parts[1].scale.mean = {0.5, 0.4, 0.1};
  return result;
}

void check_near(const Vec3& a, const Vec3& b) {
  CHECK((a - b).norm() < 1e-9);
}

}  // namespace

TEST_CASE("points of a bench come to the same places of a chair, whatever their poses") {
  const Chair bench(1.5, 0.2, 1);
  const Chair chair(0.4, 0.6, 3);
  const SurfaceToTemplate to_template(bench.surface(), chair_template());
  const TemplateToSurface to_surface(chair.surface(), chair_template());
  // The right front corner of the seat's top, and three quarters up the middle of the back's front.
  const auto corner = to_template.locate(bench.to_file({1.5, 0.1, 0.5}));
  REQUIRE(corner);
  CHECK(corner->part == 0);
  check_near(corner->local, {1, 1, 1});
  check_near(to_surface.find(*corner).value().position, chair.to_file({0.4, 0.1, 0.5}));
  const auto middle = to_template.locate(bench.to_file({0, 0.4, -0.3}));
  REQUIRE(middle);
  CHECK(middle->part == 1);
  check_near(to_surface.find(*middle).value().position, chair.to_file({0, 1.0, -0.3}));
  // A point beside the surface counts as the nearest one on it.
  check_near(to_template.locate(bench.to_file({1.7, 0, 0.2}))->local, {1, 0, 0.4});
}

TEST_CASE("what belongs to no part has no counterpart, a missing part only where a neighbour is close") {
  Chair bench(1.5, 0.2, 0);
  Chair stool(0.4, 0.6, 0);
  // The file of a shape without a back.
  PolygonMesh seat;
  add_cuboid(seat, {-0.4, -0.1, -0.5}, {0.4, 0.1, 0.5});
  stool.mesh = seat;
  for (Vec3& p : stool.mesh.vertices) p = stool.to_file(p);
  stool.labels.assign(6, 0);
  const TemplateToSurface to_stool(stool.surface(), chair_template());
  const SurfaceToTemplate to_template(bench.surface(), chair_template());
  // The top of the back is far from any seat; its foot stands on one.
  CHECK_FALSE(to_stool.find(to_template.locate(bench.to_file({0, 0.5, -0.4})).value()));
  const auto foot = to_stool.find(to_template.locate(bench.to_file({0, 0.11, -0.3})).value());
  REQUIRE(foot);
  CHECK(foot->part == 0);
  check_near(foot->position, stool.to_file({0, 0.1, -0.3}));
  // Where the other template has no such part at all, too.
  PartPoint unnamed = to_template.locate(bench.to_file({0, 0.11, -0.3})).value();
  unnamed.part = -1;
  check_near(to_stool.find(unnamed).value().position, stool.to_file({0, 0.1, -0.3}));

  std::fill_n(bench.labels.begin(), 6, null_label);
  CHECK_FALSE(SurfaceToTemplate(bench.surface(), chair_template()).locate(bench.to_file({1.5, 0, 0})));
}

TEST_CASE("the ends of a part come to its ends, though its box ends elsewhere") {
  Chair bench(1.5, 0.4, 1);
  Chair chair(0.4, 0.6, 3);
  // The boxes lie within, as those of parts that taper do.
  bench.fit.parts[1].box.half_extent.y() = 0.3;
  chair.fit.parts[1].box.half_extent.y() = 0.55;
  const std::vector<Box> boxes = carrying_boxes(bench.surface());
  check_near(boxes[0].half_extent, {1.5, 0.1, 0.5});
  CHECK(boxes[1].half_extent.y() == doctest::Approx(0.35));
  const SurfaceToTemplate to_template(bench.surface(), chair_template());
  const TemplateToSurface to_chair(chair.surface(), chair_template());
  const auto top = to_chair.find(to_template.locate(bench.to_file({0.75, 0.9, -0.5})).value());
  check_near(top.value().position, chair.to_file({0.2, 1.3, -0.5}));
}

TEST_CASE("point sets are mapped point by point") {
  Chair bench(1.5, 0.2, 0);
  Chair cloud(0.4, 0.6, 2);
  PolygonMesh points;
  points.vertices = cloud.mesh.vertices;
  cloud.mesh = points;
  cloud.labels.assign(8, 0);
  cloud.labels.resize(16, 1);
  const TemplateToSurface to_surface(cloud.surface(), chair_template());
  const auto place =
      SurfaceToTemplate(bench.surface(), chair_template()).locate(bench.to_file({1.4, 0.09, 0.5}));
  check_near(to_surface.find(place.value()).value().position, cloud.to_file({0.4, 0.1, 0.5}));
  CHECK(SurfaceToTemplate(cloud.surface(), chair_template()).locate(cloud.to_file({0.4, 1.3, -0.5}))->part ==
        1);
}

TEST_CASE("labels and fits of another shape are a mistake of the caller") {
  Chair chair(1, 1, 0);
  CHECK_THROWS_AS(TemplateToSurface(chair.surface(), PartTemplate{}), PreconditionError);
  CHECK_THROWS_AS(SurfaceToTemplate(chair.surface(), PartTemplate{}), PreconditionError);
  chair.labels[3] = 2;
  CHECK_THROWS_AS(SurfaceToTemplate(chair.surface(), chair_template()), PreconditionError);
  chair.labels.pop_back();
  CHECK_THROWS_AS(SurfaceToTemplate(chair.surface(), chair_template()), PreconditionError);
}

TEST_CASE("parts of different templates correspond by name") {
  const PartTemplate from = chair_template();
  PartTemplate to = from;
  CHECK(counterpart(from, 1, to) == 1);
  std::swap(to.parts[0], to.parts[1]);
  CHECK(counterpart(from, 1, to) == 0);
  to.parts.pop_back();
  CHECK(counterpart(from, 0, to) == -1);
}
