// Picks against what is drawn, pixel by pixel.
#include "render/picking.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/convert.h"
#include "render/gl/headless_context.h"
#include "render/renderer.h"
#include "scenes.h"

using namespace archetype;

namespace {

Rgb colour_of_number(std::size_t number) {
  return {static_cast<std::uint8_t>(number & 255U), static_cast<std::uint8_t>((number >> 8U) & 255U), 200};
}

std::shared_ptr<const Colours> numbered(std::size_t first, std::size_t count) {
  auto colours = std::make_shared<Colours>();
  for (std::size_t i = 0; i < count; ++i) colours->push_back(colour_of_number(first + i));
  return colours;
}

struct Agreement {
  int same = 0;
  int other = 0;
  int hits = 0;
};

// Compares the number that each pixel's colour tells with the pick at its centre.
template <class NumberOf>
Agreement compare(Renderer& renderer, const Scene& scene, const Camera& camera, const Viewport& viewport,
                  NumberOf number_of) {
  RenderTarget target;
  renderer.draw(scene, camera, {viewport.width, viewport.height}, target);
  const Picture picture = target.read();
  Agreement agreement;
  for (int y = 0; y < viewport.height; ++y)
    for (int x = 0; x < viewport.width; ++x) {
      const Pick pick = pick_surface(scene, camera, viewport, {x + 0.5, y + 0.5});
      const bool drawn = alpha_of(picture, x, y) != 0;
      agreement.hits += drawn ? 1 : 0;
      const bool same = pick.kind == PickKind::nothing
                            ? !drawn
                            : drawn && pixel_of(picture, x, y) == colour_of_number(number_of(pick));
      ++(same ? agreement.same : agreement.other);
    }
  return agreement;
}

}  // namespace

TEST_CASE("the face that is picked is the face that is drawn") {
  const gl::HeadlessContext context;
  Renderer renderer(shader_folder());
  const auto geometry = geometry_of(random_soup(300, 11));
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  scene.meshes.push_back({.geometry = geometry, .face_colours = numbered(0, 300), .lit = false});
  scene.meshes.push_back({.geometry = geometry, .face_colours = numbered(300, 300), .lit = false});
  scene.meshes[1].transform = glm::scale(
      glm::rotate(glm::translate(glm::mat4(1), {1.5F, 0.2F, 0}), 0.7F, {0, 1, 0}), glm::vec3(0.6F));
  const Viewport viewport{240, 160};
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    frame(camera, viewport, {-1.4, -1.4, -1.4}, {2.5, 1.4, 1.4});
    const Agreement agreement = compare(renderer, scene, camera, viewport,
                                        [](const Pick& pick) { return 300 * pick.object + pick.element; });
    CHECK(agreement.hits > 5000);
    // The rasteriser snaps corners to 1/256 pixel and depths to 24 bits: pixels whose centre lies on an edge
    // or cut may differ, no others.
    CHECK(agreement.other <= agreement.same / 1000);
  }
}

TEST_CASE("the point that is picked is the point that is drawn") {
  const gl::HeadlessContext context;
  Renderer renderer(shader_folder());
  PolygonMesh cloud;
  RandomStream random(4);
  for (int i = 0; i < 200; ++i)
    cloud.vertices.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  scene.points.push_back(
      {.geometry = std::make_shared<PointGeometry>(make_point_geometry(cloud, ShapeFrame{})),
       .colours = numbered(0, 200),
       .radius = 0.08F,
       .lit = false});
  const Viewport viewport{240, 160};
  Camera camera;
  frame(camera, viewport, {-1, -1, -1}, {1, 1, 1});
  RenderTarget target;
  renderer.draw(scene, camera, {viewport.width, viewport.height}, target);
  const Picture picture = target.read();
  int hits = 0;
  int missed = 0;
  for (int y = 0; y < viewport.height; ++y)
    for (int x = 0; x < viewport.width; ++x) {
      const Pick pick = pick_surface(scene, camera, viewport, {x + 0.5, y + 0.5});
      const bool drawn = alpha_of(picture, x, y) != 0;
      hits += drawn ? 1 : 0;
      if (drawn != (pick.kind == PickKind::point)) ++missed;
    }
  CHECK(hits > 3000);
  CHECK(missed <= hits / 100);
}

TEST_CASE("boxes are picked nearest first, by the side that the ray enters") {
  Scene scene;
  for (const double z : {-2.0, 1.0, 0.0}) scene.boxes.push_back({.box = {Vec3(0, 0, z), Vec3(1, 1, 0.25)}});
  scene.boxes.push_back({.box = {Vec3(5, 0, 0), Vec3(1, 1, 1)}});
  const auto picks = pick_boxes(scene, {{0.1, 0.2, 10}, {0, 0, -1}});
  REQUIRE(picks.size() == 3);
  CHECK(picks[0].object == 1);
  CHECK(picks[1].object == 2);
  CHECK(picks[2].object == 0);
  CHECK(picks[0].element == 5);
  CHECK(picks[0].distance == doctest::Approx(8.75));
  CHECK(glm::length(picks[0].position - glm::dvec3(0.1, 0.2, 1.25)) < 1e-12);

  SUBCASE("from inside the far side counts") {
    const auto inside = pick_boxes(scene, {{0, 0, 1}, {0, 1, 0}});
    REQUIRE(inside.size() == 1);
    CHECK(inside[0].element == 3);
    CHECK(inside[0].distance == doctest::Approx(1));
  }
  SUBCASE("boxes behind the eye do not count") {
    CHECK(pick_boxes(scene, {{0, 0, 10}, {0, 0, 1}}).empty());
  }
}

TEST_CASE("turned boxes agree with points on their surface") {
  RandomStream random(9);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto within = [&] {
      return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    Scene scene;
    scene.boxes.push_back(
        {.box = {within(), Vec3(0.3, 0.5, 0.7),
                 Eigen::Quaterniond(1, within().x(), within().y(), within().z()).normalized()}});
    const Ray ray{to_glm(Vec3(4 * within())), glm::normalize(to_glm(within()))};
    for (const Pick& pick : pick_boxes(scene, ray)) {
      ++hits;
      const Vec3 local = scene.boxes[0].box.to_local(to_eigen(pick.position));
      const double side = pick.element % 2 == 0 ? -1 : 1;
      CHECK(local[static_cast<int>(pick.element / 2)] == doctest::Approx(side));
      CHECK(local.cwiseAbs().maxCoeff() < 1 + 1e-9);
    }
  }
  CHECK(hits > 20);
}
