// Clouds that come part by part, and pictures in pieces: the same pixels as in one go.
#include "render/large_picture.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/base/error.h"
#include "render/convert.h"
#include "render/gl/headless_context.h"
#include "render/picking.h"
#include "scenes.h"

using namespace archetype;

namespace {

struct Studio {
  gl::HeadlessContext context;
  Renderer renderer{shader_folder()};
};

std::shared_ptr<const PointGeometry> random_points(std::size_t n) {
  auto geometry = std::make_shared<PointGeometry>();
  RandomStream random(3);
  for (std::size_t i = 0; i < n; ++i) {
    const auto any = [&] { return static_cast<float>(random.uniform(-1, 1)); };
    geometry->positions.emplace_back(any(), any(), any());
    geometry->moved.emplace_back(any(), any(), any());
  }
  geometry->spacing = 0.05F;
  return geometry;
}

Scene cloud_scene(std::size_t n) {
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  auto colours = std::make_shared<Colours>();
  RandomStream random(4);
  for (std::size_t i = 0; i < n; ++i)
    colours->push_back({static_cast<std::uint8_t>(random.below(256)), 80, 200});
  scene.points.push_back({.geometry = random_points(n), .colours = colours});
  return scene;
}

// Of pixels that differ by more than rounding.
double share_that_differs(const Picture& a, const Picture& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k)
      if (std::abs(a.pixels[i + k] - b.pixels[i + k]) > 2) {
        ++count;
        break;
      }
  return static_cast<double>(count) / (static_cast<double>(a.pixels.size()) / 4);
}

}  // namespace

TEST_CASE("a cloud that comes part by part ends as the whole") {
  Studio studio;
  Scene scene = cloud_scene(900);
  RenderTarget whole;
  RenderTarget parts;
  const PictureSize size{160, 120};
  studio.renderer.draw(scene, {}, size, whole);
  scene.points[0].most = 300;
  studio.renderer.draw(scene, {}, size, parts);
  const Picture first = parts.read();
  CHECK(share_that_differs(first, whole.read()) > 0.1);
  for (const std::size_t begin : {300, 600}) {
    scene.points[0].first = begin;
    studio.renderer.draw_more_points(scene, {}, parts);
  }
  CHECK(parts.read() == whole.read());
  scene.points[0].first = 5000;  // beyond the last
  studio.renderer.draw_more_points(scene, {}, parts);
  CHECK(parts.read() == whole.read());
  studio.renderer.draw(scene, {}, {160, 120, 2}, parts);
  CHECK_THROWS_AS(studio.renderer.draw_more_points(scene, {}, parts), PreconditionError);
}

TEST_CASE("points are drawn and picked between their two places") {
  Studio studio;
  auto geometry = std::make_shared<PointGeometry>();
  geometry->positions = {{-0.5F, 0, 0}};
  geometry->moved = {{0.5F, 0, 0}};
  geometry->spacing = 0.1F;
  Camera camera;
  look_from(camera, ViewPreset::front);
  const Viewport viewport{200, 150};
  for (const float blend : {0.F, 0.25F, 1.F}) {
    Scene scene;
    scene.backdrop = Backdrop::transparent;
    scene.points.push_back({.geometry = geometry, .blend = blend});
    RenderTarget target;
    studio.renderer.draw(scene, camera, {viewport.width, viewport.height}, target);
    const auto at = to_screen(camera, viewport, {-0.5 + blend, 0, 0});
    REQUIRE(at);
    CHECK(alpha_of(target.read(), static_cast<int>(at->x), static_cast<int>(at->y)) == 255);
    const Pick pick = pick_surface(scene, camera, viewport, *at);
    CHECK(pick.kind == PickKind::point);
    scene.points[0].first = 1;  // what is not drawn is not picked
    CHECK(pick_surface(scene, camera, viewport, *at).kind == PickKind::nothing);
  }
}

TEST_CASE("a picture in pieces is the picture in one") {
  Studio studio;
  Scene scene = cloud_scene(400);
  scene.meshes.push_back({.geometry = geometry_of(random_soup(30, 5)), .edges = true});
  scene.boxes.push_back({.box = {{0.2, 0, 0}, {0.9, 0.5, 0.7}}, .dash = 5});
  const PictureSize size{1500, 1100, 2};
  RenderTarget target;
  studio.renderer.draw(scene, {}, size, target);
  const auto picture = draw_large_picture(studio.renderer, scene, {}, size);
  REQUIRE(picture);
  CHECK(picture->width == 1500);
  CHECK(share_that_differs(*picture, target.read()) < 0.002);
  std::stop_source stop;
  stop.request_stop();
  JobControl control;
  control.stop = stop.get_token();
  CHECK_FALSE(draw_large_picture(studio.renderer, scene, {}, size, control));
}

TEST_CASE("pictures are laid over each other by their opacity") {
  Picture page{2, 1, {255, 255, 255, 255, 0, 0, 0, 0}};
  lay_over(page, {1, 1, {0, 0, 0, 128}}, 0, 0);
  CHECK(page.pixels[0] == 127);
  CHECK(page.pixels[3] == 255);
  lay_over(page, {1, 1, {10, 20, 30, 128}}, 1, 0);
  CHECK(page.pixels[4] == 10);
  CHECK(page.pixels[7] == 128);
  const Picture before = page;
  lay_over(page, {1, 1, {9, 9, 9, 255}}, 2, 0);  // outside
  lay_over(page, {1, 1, {9, 9, 9, 255}}, 0, -1);
  CHECK(page == before);
}
