// What the viewport shows, as plain data.
#include "ui/viewport_scene.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "render/convert.h"
#include "ui/heat_map.h"

using namespace archetype;

namespace {

ShapeDisplay one_triangle() {
  auto mesh = std::make_shared<PolygonMesh>();
  mesh->vertices = {{0, -1, 0}, {1, 0, 0}, {0, 2, 0.5}};
  mesh->add_face(std::array<std::uint32_t, 3>{0, 1, 2});
  auto samples = std::make_shared<ShapeSamples>();
  samples->points = mesh->vertices;
  samples->normals.assign(3, Vec3::UnitZ());
  return *make_shape_display({mesh, samples, ShapeFrame{}, 5}, {});
}

PartTemplate two_parts() {
  PartTemplate parts;
  parts.parts.resize(2);
  parts.parts[1].position.mean = Vec3(3, 0, 0);
  return parts;
}

ViewFit fit_of(const PartTemplate& part_template, int yaw_quarters) {
  ViewFit fit;
  fit.fit.yaw_quarters = yaw_quarters;
  fit.fit.translation = Vec3(0.1, 0.2, 0.3);
  for (const TemplatePart& part : part_template.parts) fit.fit.parts.push_back({true, part.mean_box()});
  fit.fit.labels = {0, 1, -1};
  fit.element_labels = {1};
  return fit;
}

}  // namespace

TEST_CASE(
    "the shape is turned by the yaw of the fit but not shifted, so that boxes stay where they are put") {
  const PartTemplate parts = two_parts();
  for (int yaw = 0; yaw < 4; ++yaw) {
    const ViewFit fit = fit_of(parts, yaw);
    ViewportContent content;
    content.part_template = &parts;
    content.fit = &fit;
    content.display = one_triangle();
    const Scene scene = make_viewport_scene(content);
    REQUIRE(scene.meshes.size() == 1);
    const Vec3 p(0.3, 0.4, 0.5);
    const Vec3 expected = fit.fit.to_template(p) + fit.fit.translation;
    const glm::vec4 shown = scene.meshes[0].transform * glm::vec4(0.3, 0.4, 0.5, 1);
    CHECK(glm::length(glm::dvec3(shown) - to_glm(expected)) < 1e-6);
    CHECK(scene.boxes[1].box.centre == parts.parts[1].position.mean);
  }
}

TEST_CASE("fitted boxes stand where the shape's parts are seen") {
  const PartTemplate parts = two_parts();
  const ViewFit fit = fit_of(parts, 1);
  ViewportContent content;
  content.part_template = &parts;
  content.fit = &fit;
  content.view.fitted_boxes = true;
  content.view.mean_boxes = false;
  const Scene scene = make_viewport_scene(content);
  REQUIRE(scene.boxes.size() == 2);
  CHECK((scene.boxes[0].box.centre - fit.fit.translation).norm() < 1e-12);
}

TEST_CASE("faces and samples take the colours of their parts, and labels of another shape are left out") {
  const PartTemplate parts = two_parts();
  ViewFit fit = fit_of(parts, 0);
  const ShapeDisplay display = one_triangle();
  ShapeColours colours = colours_of_fit(fit, display);
  REQUIRE(colours.elements);
  CHECK(colours.elements->front() == part_colour(1));
  REQUIRE(colours.samples);
  CHECK(colours.samples->back() == part_colour(-1));
  fit.element_labels.resize(7);
  fit.fit.labels.clear();
  colours = colours_of_fit(fit, display);
  CHECK_FALSE(colours.elements);
  CHECK_FALSE(colours.samples);
}

TEST_CASE("switches decide what is drawn") {
  const PartTemplate parts = two_parts();
  ViewportContent content;
  content.part_template = &parts;
  content.display = one_triangle();
  CHECK(make_viewport_scene(content).points.empty());
  content.view.points = true;
  CHECK(make_viewport_scene(content).points.size() == 1);
  content.view.surface = false;
  CHECK(make_viewport_scene(content).meshes.empty());
  content.view.wireframe = true;
  CHECK_FALSE(make_viewport_scene(content).meshes[0].surface);
  content.view.mean_boxes = false;
  CHECK(make_viewport_scene(content).boxes.empty());
  content.display.mesh.reset();
  content.view.points = false;
  CHECK(make_viewport_scene(content).points.size() == 1);  // the file is gone: its samples stand in
}

TEST_CASE("what is framed holds the shape and all boxes, or the selected box alone") {
  const PartTemplate parts = two_parts();
  ViewportContent content;
  CHECK_FALSE(extent_to_frame(content));
  content.part_template = &parts;
  content.display = one_triangle();
  auto extent = extent_to_frame(content);
  REQUIRE(extent);
  CHECK(extent->second.x == doctest::Approx(3.2));
  CHECK(extent->second.y == doctest::Approx(2));
  content.selected = 1;
  extent = extent_to_frame(content);
  CHECK(extent->first.x == doctest::Approx(2.8));
}

TEST_CASE("a large mesh is drawn coarser while something moves, with the same colours") {
  PolygonMesh field;
  constexpr std::uint32_t side = 170;
  for (std::uint32_t i = 0; i <= side; ++i)
    for (std::uint32_t j = 0; j <= side; ++j) field.vertices.emplace_back(0.01 * i, 0, 0.01 * j);
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t first = i * (side + 1) + j;
      field.add_face(std::array{first, first + 1, first + side + 2, first + side + 1});
    }
  const std::size_t most = 20'000;
  const ShapeDisplayRequest request{std::make_shared<PolygonMesh>(field), nullptr, ShapeFrame{}, 3, most};
  ViewportContent content;
  content.display = *make_shape_display(request, {});
  CHECK(content.display.mesh->triangle_count() == 2 * side * side);
  const auto coarse = make_coarse_mesh(request, {});
  REQUIRE(coarse);
  content.display.coarse = coarse->mesh;
  CHECK(coarse->mesh->triangle_count() <= most / 2);
  CHECK(coarse->mesh->face_count == field.face_count());
  // Each triangle has the colour of a face that lies where it does.
  for (std::size_t t = 0; t < coarse->mesh->triangle_count(); t += 97) {
    const Vec3 centre = face_centre(field, coarse->mesh->faces[t]);
    CHECK(glm::length(glm::dvec3(coarse->mesh->positions[3 * t]) - to_glm(centre)) < 0.3);
  }
  CHECK(make_viewport_scene(content).meshes[0].geometry == content.display.mesh);
  content.moving = true;
  CHECK(make_viewport_scene(content).meshes[0].geometry == content.display.coarse);
}

TEST_CASE("the spread is an ellipsoid for the position and two dashed lines an axis for the size") {
  PartTemplate one;
  TemplatePart part;
  part.position = {Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3)};
  part.scale = {Vec3(0.5, 0.6, 0.7), Vec3(0.1, 0.2, 0.9)};
  one.parts.push_back(part);
  ViewportContent content;
  content.part_template = &one;
  CHECK(make_viewport_scene(content).ellipsoids.empty());
  content.view.spread = true;
  const Scene scene = make_viewport_scene(content);
  REQUIRE(scene.ellipsoids.size() == 1);
  CHECK(scene.ellipsoids[0].axes.centre == part.position.mean);
  CHECK(scene.ellipsoids[0].axes.half_extent == part.position.stddev);
  REQUIRE(scene.lines.size() == 6);
  for (const SceneLine& line : scene.lines) CHECK(line.dash > 0);
  CHECK(scene.lines[1].from.x == doctest::Approx(1.4));
  CHECK(scene.lines[1].to.x == doctest::Approx(1.6));
  CHECK(scene.lines[5].from.z == doctest::Approx(3));  // not beyond the centre
  CHECK(scene.lines[5].to.z == doctest::Approx(4.6));
}

TEST_CASE("as a heat map faces and samples take the colours of their costs, the dearer the lighter") {
  const PartTemplate parts = two_parts();
  ViewFit fit = fit_of(parts, 0);
  fit.sample_costs = {0.1, 0.9, 5};
  fit.element_costs = {0.5F};
  ViewportContent content;
  content.fit = &fit;
  content.display = one_triangle();
  content.view.colour = SurfaceColour::cost;
  content.colours = colours_of_fit(fit, content.display, SurfaceColour::cost);
  CHECK((*content.colours.elements)[0] == heat_colour(0.5));
  CHECK((*content.colours.samples)[2] == heat_colour(1));
  const Scene scene = make_viewport_scene(content);
  CHECK(scene.meshes[0].face_colours == content.colours.elements);
  REQUIRE(scene.points.size() == 1);  // one large face tells less than its three samples
  CHECK(scene.points[0].colours == content.colours.samples);
  fit.element_costs = {0.5F, 0.5F};  // of another shape
  CHECK_FALSE(colours_of_fit(fit, content.display, SurfaceColour::cost).elements);
  const auto lightness = [](const Rgb& c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; };
  for (int i = 0; i < 20; ++i)
    CHECK(lightness(heat_colour((i + 1) / 20.0)) > lightness(heat_colour(i / 20.0)));
}
