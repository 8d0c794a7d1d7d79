// The camera's maths.
#include "render/camera.h"

#include <doctest/doctest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "core/base/random.h"

using namespace archetype;

namespace {

constexpr Viewport viewport{1280, 720};

std::vector<Camera> some_cameras() {
  std::vector<Camera> cameras;
  RandomStream random(7);
  for (int i = 0; i < 60; ++i) {
    Camera camera;
    camera.target = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    orbit(camera, random.uniform(-4, 4), random.uniform(-2, 2));
    camera.distance = random.uniform(0.2, 9);
    camera.orthographic = i % 2 == 1;
    cameras.push_back(camera);
  }
  return cameras;
}

double pixels_between(const glm::dvec2& a, const glm::dvec2& b) {
  return glm::length(a - b);
}

}  // namespace

TEST_CASE("the ray through a pixel meets what is drawn at that pixel") {
  for (const Camera& camera : some_cameras())
    for (const glm::dvec2 pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(640, 360), glm::dvec2(1100.25, 33)}) {
      const Ray ray = ray_through(camera, viewport, pixel);
      CHECK(glm::length(ray.direction) == doctest::Approx(1));
      for (const double way : {0.1, 1.0, 5.0}) {
        const auto back = to_screen(camera, viewport, ray.origin + way * camera.distance * ray.direction);
        REQUIRE(back);
        CHECK(pixels_between(*back, pixel) < 1e-6);
      }
    }
}

TEST_CASE("zooming keeps what is under the cursor there") {
  for (const Camera& before : some_cameras()) {
    const glm::dvec2 cursor(900, 150);
    const Ray ray = ray_through(before, viewport, cursor);
    Camera after = before;
    zoom(after, viewport, cursor, 0.8);
    CHECK(after.distance == doctest::Approx(0.8 * before.distance));
    // At whatever depth it lies.
    for (const double way : {0.5, 1.0, 3.0}) {
      const glm::dvec3 point = ray.origin + way * before.distance * ray.direction;
      CHECK(pixels_between(*to_screen(after, viewport, point), cursor) < 1e-6);
    }
    zoom(after, viewport, cursor, 1 / 0.8);
    CHECK(glm::length(after.target - before.target) < 1e-9);
  }
}

TEST_CASE("panning moves what lies at the depth of the target along with the cursor") {
  for (Camera camera : some_cameras()) {
    const glm::dvec3 point = camera.target;
    pan(camera, viewport, {640, 360}, {300, 500});
    CHECK(pixels_between(*to_screen(camera, viewport, point), {300, 500}) < 1e-6);
  }
}

TEST_CASE("a framed box lies in the picture and fills it") {
  for (Camera camera : some_cameras())
    for (const Viewport size : {Viewport{1280, 720}, Viewport{300, 900}}) {
      const glm::dvec3 low(-1, 0, 2);
      const glm::dvec3 high(0.5, 3, 2.25);
      frame(camera, size, low, high, 0.1);
      double widest = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                           (corner & 4) != 0 ? high.z : low.z);
        const auto pixel = to_screen(camera, size, p);
        REQUIRE(pixel);
        widest = std::max(widest, std::abs(pixel->x / size.width - 0.5) * 2);
        widest = std::max(widest, std::abs(pixel->y / size.height - 0.5) * 2);
      }
      CHECK(widest == doctest::Approx(0.9));
    }
}

TEST_CASE("framed points lie in the picture and touch two opposite sides of it") {
  RandomStream random(3);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(random.uniform(2, 4), random.uniform(-1, 0), random.uniform(-3, 3));
  for (Camera camera : some_cameras()) {
    frame_points(camera, viewport, points, 0.1);
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    for (const glm::vec3& p : points) {
      const auto pixel = to_screen(camera, viewport, p);
      REQUIRE(pixel);
      low = glm::min(low, *pixel / glm::dvec2(viewport.width, viewport.height) * 2.0 - 1.0);
      high = glm::max(high, *pixel / glm::dvec2(viewport.width, viewport.height) * 2.0 - 1.0);
    }
    CHECK(low.x == doctest::Approx(-high.x).epsilon(0.02));
    CHECK(low.y == doctest::Approx(-high.y).epsilon(0.02));
    CHECK(std::max(high.x, high.y) == doctest::Approx(0.9));
  }
}

TEST_CASE("presets look along the axes, with the right side up") {
  Camera camera;
  const auto sees = [&](ViewPreset preset) {
    look_from(camera, preset);
    return -back_axis(camera);
  };
  CHECK(glm::length(sees(ViewPreset::front) - glm::dvec3(0, 0, -1)) < 1e-12);
  CHECK(glm::length(sees(ViewPreset::back) - glm::dvec3(0, 0, 1)) < 1e-12);
  CHECK(glm::length(sees(ViewPreset::right) - glm::dvec3(-1, 0, 0)) < 1e-12);
  CHECK(glm::length(sees(ViewPreset::left) - glm::dvec3(1, 0, 0)) < 1e-12);
  CHECK(glm::length(sees(ViewPreset::bottom) - glm::dvec3(0, 1, 0)) < 1e-12);
  CHECK(glm::length(sees(ViewPreset::top) - glm::dvec3(0, -1, 0)) < 1e-12);
  CHECK(glm::length(up_axis(camera) - glm::dvec3(0, 0, -1)) < 1e-12);
}

TEST_CASE("a point behind the eye is nowhere on the screen") {
  Camera camera;
  CHECK_FALSE(to_screen(camera, viewport, eye(camera) + back_axis(camera)));
}

TEST_CASE("a camera has to follow what outgrows its picture, if it was not moved and saw all there was") {
  for (const bool orthographic : {false, true}) {
    CAPTURE(orthographic);
    Camera camera;
    camera.orthographic = orthographic;
    frame(camera, viewport, glm::dvec3(-1), glm::dvec3(1), 0);
    const auto corners = [](float size) {
      std::vector<glm::vec3> points;
      for (int i = 0; i < 8; ++i)
        points.emplace_back((i & 1) != 0 ? size : -size, (i & 2) != 0 ? size : -size,
                            (i & 4) != 0 ? size : -size);
      return points;
    };
    CHECK(shows_all(camera, viewport, corners(0.999F)));
    CHECK_FALSE(shows_all(camera, viewport, corners(1.001F)));

    WholeView seen;
    CHECK_FALSE(outgrows(seen, camera, viewport, corners(0.5F)));
    CHECK(outgrows(seen, camera, viewport, corners(1.5F)));
    CHECK_FALSE(outgrows(seen, camera, viewport, corners(2)));  // it stuck out before
    CHECK_FALSE(outgrows(seen, camera, viewport, corners(0.5F)));
    camera.distance *= 0.9;  // moved: the shape that sticks out now is not another one
    CHECK_FALSE(outgrows(seen, camera, viewport, corners(0.95F)));
  }
}

TEST_CASE("blending ends exactly at its ends and turns the shorter way") {
  Camera from;
  from.yaw = 3.0;
  Camera to;
  to.yaw = -3.0;
  to.distance = 20;
  CHECK(blend(from, to, 0) == from);
  CHECK(blend(from, to, 1) == to);
  CHECK(blend(from, to, 0.5).yaw > 3.0);
  CHECK(blend(from, to, 0.5).distance == doctest::Approx(10));
}
