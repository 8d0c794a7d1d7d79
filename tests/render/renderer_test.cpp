// Pictures: the right things at the right pixels.
#include "render/renderer.h"

#include <doctest/doctest.h>

#include <cmath>

#include "render/convert.h"
#include "render/gl/headless_context.h"
#include "render/thumbnails.h"
#include "scenes.h"

using namespace archetype;

namespace {

constexpr Viewport viewport{200, 150};
constexpr Rgb red{220, 30, 30};
constexpr Rgb green{30, 200, 30};

// Looks along -z at the plane z = 0; the picture is 3 units high there.
Camera front_camera() {
  Camera camera;
  look_from(camera, ViewPreset::front);
  camera.orthographic = true;
  camera.distance = 1.5 / std::tan(0.5 * camera.field_of_view);
  return camera;
}

struct Studio {
  gl::HeadlessContext context;
  Renderer renderer{shader_folder()};
  RenderTarget target;
  Picture draw(const Scene& scene, const Camera& camera = front_camera(), int supersample = 1) {
    renderer.draw(scene, camera, {viewport.width, viewport.height, supersample}, target);
    return target.read();
  }
};

int difference(const Rgb& a, const Rgb& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

Scene square_scene() {
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  scene.meshes.push_back({.geometry = geometry_of(square(0)), .colour = red, .lit = false});
  return scene;
}

}  // namespace

TEST_CASE("a square covers exactly its pixels") {
  Studio studio;
  const Picture picture = studio.draw(square_scene());
  int covered = 0;
  for (int y = 0; y < viewport.height; ++y)
    for (int x = 0; x < viewport.width; ++x)
      if (alpha_of(picture, x, y) != 0) {
        ++covered;
        CHECK(difference(pixel_of(picture, x, y), red) <= 3);
      }
  CHECK(covered == 100 * 100);  // 2 of 3 units of 150 pixels
  CHECK(alpha_of(picture, 51, 26) == 255);
  CHECK(alpha_of(picture, 48, 23) == 0);
}

TEST_CASE("both sides of a surface are lit alike") {
  Studio studio;
  Scene scene = square_scene();
  scene.meshes[0].lit = true;
  const Rgb from_front = pixel_of(studio.draw(scene), 100, 75);
  PolygonMesh turned = square(0);
  std::reverse(turned.face_corners.begin(), turned.face_corners.end());
  scene.meshes[0].geometry = geometry_of(turned);
  CHECK(difference(pixel_of(studio.draw(scene), 100, 75), from_front) <= 2);
  CHECK(from_front[0] > 150);
}

TEST_CASE("faces have their own colours, and new ones show at once") {
  Studio studio;
  PolygonMesh mesh = square(0);
  mesh.face_corners = {0, 1, 2, 0, 2, 3};
  mesh.face_begins = {0, 3, 6};
  Scene scene = square_scene();
  scene.meshes[0].geometry = geometry_of(mesh);
  for (const bool swapped : {false, true}) {
    scene.meshes[0].face_colours =
        std::make_shared<Colours>(swapped ? Colours{green, red} : Colours{red, green});
    const Picture picture = studio.draw(scene);
    CHECK(difference(pixel_of(picture, 130, 100), swapped ? green : red) <= 3);
    CHECK(difference(pixel_of(picture, 70, 50), swapped ? red : green) <= 3);
  }
}

TEST_CASE("a box face that lies in the surface is seen everywhere, whatever the view") {
  Studio studio;
  Scene scene = square_scene();
  scene.boxes.push_back(
      {.box = {Vec3(0, 0, -0.5), Vec3(0.9, 0.9, 0.5)}, .colour = green, .fill = 0.5F, .outline_width = 0});
  for (const double yaw : {0.0, 0.5, 1.1}) {
    Camera camera = front_camera();
    camera.orthographic = false;
    orbit(camera, yaw, 0.3);
    const Picture with_box = studio.draw(scene, camera);
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j) {
        const auto pixel = to_screen(camera, viewport, {0.1 * i, 0.1 * j, 0});
        REQUIRE(pixel);
        const Rgb colour = pixel_of(with_box, static_cast<int>(pixel->x), static_cast<int>(pixel->y));
        CHECK(colour[1] > 90);  // half of green over red
        CHECK(colour[1] < 185);
      }
  }
}

TEST_CASE("outlines are clear in front of a surface and faint behind it") {
  Studio studio;
  Scene scene = square_scene();
  const Picture bare = studio.draw(scene);
  for (const double z : {0.5, -0.5}) {
    scene.boxes = {
        {.box = {Vec3(0, 0, z), Vec3(0.5, 0.5, 0.1)}, .colour = green, .fill = 0, .outline_width = 3}};
    const Picture picture = studio.draw(scene);
    // The middle of the upper edge.
    const Rgb on_edge = pixel_of(picture, 100, 50);
    if (z > 0)
      CHECK(difference(on_edge, green) <= 6);
    else
      CHECK(difference(on_edge, pixel_of(bare, 100, 50)) > 20);
    if (z < 0) CHECK(difference(on_edge, green) > 100);
    CHECK(difference(pixel_of(picture, 100, 75), red) <= 3);
  }
  scene.hidden_lines = 0;
  CHECK(studio.draw(scene) == bare);
}

TEST_CASE("lines are as wide as asked, also at another scale, and dashes leave gaps") {
  Studio studio;
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  scene.lines.push_back({.from = {-1, 0, 0}, .to = {1, 0, 0}, .colour = red, .width = 6});
  const auto rows = [&](const Picture& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y) sum += alpha_of(picture, picture.width / 2, y) / 255.0;
    return sum;
  };
  CHECK(rows(studio.draw(scene)) == doctest::Approx(6).epsilon(0.05));
  CHECK(rows(studio.draw(scene, front_camera(), 3)) == doctest::Approx(6).epsilon(0.05));
  studio.renderer.draw(scene, front_camera(), {400, 300, 1, 2.0F}, studio.target);
  CHECK(rows(studio.target.read()) == doctest::Approx(12).epsilon(0.05));

  scene.lines[0].dash = 10;
  const Picture dashed = studio.draw(scene);
  int inked = 0;
  for (int x = 50; x < 150; ++x) inked += alpha_of(dashed, x, 75) > 127 ? 1 : 0;
  CHECK(inked > 40);
  CHECK(inked < 60);
}

TEST_CASE("a line that passes the eye is cut off there and goes on in the right direction") {
  Studio studio;
  Camera camera;
  look_from(camera, ViewPreset::front);
  Scene scene;
  scene.backdrop = Backdrop::transparent;
  scene.lines.push_back({.from = {0, -1, 0}, .to = {0, -1, 50}, .colour = red, .width = 4});
  const Picture picture = studio.draw(scene, camera);
  const auto start = to_screen(camera, viewport, {0, -1, 0});
  CHECK(alpha_of(picture, 100, static_cast<int>(start->y) + 5) > 200);
  CHECK(alpha_of(picture, 100, viewport.height - 1) > 200);
  CHECK(alpha_of(picture, 100, 20) == 0);
}

TEST_CASE("wireframes show the sides of the file's faces and no diagonals") {
  Studio studio;
  Scene scene = square_scene();
  scene.meshes[0].surface = false;
  scene.meshes[0].edges = true;
  const Picture picture = studio.draw(scene);
  CHECK(alpha_of(picture, 50, 75) == 255);
  int inside = 0;
  for (int y = 30; y < 120; ++y)
    for (int x = 55; x < 145; ++x) inside += alpha_of(picture, x, y) != 0 ? 1 : 0;
  CHECK(inside == 0);
}

TEST_CASE("the same scene gives the same picture, and supersampling smooths its edges") {
  Studio studio;
  Scene scene = square_scene();
  scene.backdrop = Backdrop::dark;
  scene.grid = true;
  scene.ground = -1;
  Camera camera = front_camera();
  orbit(camera, 0.4, 0.3);
  const Picture first = studio.draw(scene, camera, 2);
  CHECK(studio.draw(scene, camera, 2) == first);
  CHECK_FALSE(studio.draw(scene, camera) == first);
}

TEST_CASE("uploads are shared while geometry lives and freed with it") {
  Studio studio;
  Scene scene = square_scene();
  studio.draw(scene);
  const std::size_t once = studio.renderer.uploaded_bytes();
  CHECK(once > 0);
  scene.meshes.push_back(scene.meshes[0]);
  studio.draw(scene);
  CHECK(studio.renderer.uploaded_bytes() == once);
  scene.meshes.clear();
  studio.draw(scene);
  CHECK(studio.renderer.uploaded_bytes() == 0);
}

TEST_CASE("empty and odd scenes are drawn without complaint") {
  Studio studio;
  Scene scene;
  studio.draw(scene);
  scene.meshes.push_back({});
  scene.points.push_back({});
  scene.meshes.push_back({.geometry = geometry_of(PolygonMesh{})});
  scene.points.push_back({.geometry = std::make_shared<PointGeometry>()});
  scene.boxes.push_back({.box = {Vec3::Zero(), Vec3::Zero()}});
  scene.ellipsoids.push_back({.axes = {Vec3::Zero(), Vec3(1, 0, 1)}});
  scene.grid = true;
  studio.draw(scene);
  studio.renderer.draw(scene, front_camera(), {0, -5, 9}, studio.target);
  CHECK(studio.target.size() == PictureSize{1, 1, 4});
}

TEST_CASE("thumbnails fill their square and leave the rest transparent") {
  Studio studio;
  const Picture picture = mesh_thumbnail(studio.renderer, geometry_of(random_soup(50, 2)),
                                         colours_of_labels(std::vector<std::int16_t>(50, 2)), {.size = 96});
  CHECK(picture.width == 96);
  CHECK(picture.height == 96);
  CHECK(alpha_of(picture, 0, 0) == 0);
  int covered = 0;
  int low = 96;
  int high = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      if (alpha_of(picture, x, y) > 127) {
        ++covered;
        low = std::min({low, x, y});
        high = std::max({high, x, y});
      }
  CHECK(covered > 96 * 96 / 8);
  CHECK(low < 6);
  CHECK(high > 89);
}

TEST_CASE("thumbnails of one kind are drawn at one scale, larger shapes whole, masks in exact colours") {
  Studio studio;
  const auto geometry = geometry_of(square(0));  // from -1 to 1
  const auto covered = [](const Picture& picture) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) count += alpha_of(picture, x, y) > 127;
    return count;
  };
  const auto corners = [](float half) {
    std::vector<glm::vec3> all;
    for (int i = 0; i < 8; ++i)
      all.emplace_back((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half);
    return all;
  };
  ThumbnailOptions options{.size = 96, .framed = corners(2)};
  const int small = covered(mesh_thumbnail(studio.renderer, geometry, nullptr, options));
  options.transform = glm::mat4(0.5f);
  options.transform[3][3] = 1;
  const int half = covered(mesh_thumbnail(studio.renderer, geometry, nullptr, options));
  CHECK(half > small / 6);
  CHECK(half < small / 3);  // a quarter of the area: the scale is that of the frame, not of the shape
  options.transform = glm::mat4(1);
  options.framed = corners(0.2f);  // the shape is far larger
  const Picture whole = mesh_thumbnail(studio.renderer, geometry, nullptr, options);
  for (int i = 0; i < 96; ++i) {
    CHECK(alpha_of(whole, i, 0) == 0);
    CHECK(alpha_of(whole, 0, i) == 0);
  }
  options = {.size = 96, .mask = true};
  const auto colours = std::make_shared<Colours>(geometry->face_count, Rgb{7, 1, 0});
  const Picture mask = mesh_thumbnail(studio.renderer, geometry, colours, options);
  int exact = 0;
  for (std::size_t i = 0; i < mask.pixels.size(); i += 4) {
    if (mask.pixels[i + 3] == 0) continue;
    ++exact;
    CHECK(mask.pixels[i] == 7);
    CHECK(mask.pixels[i + 1] == 1);
    CHECK(mask.pixels[i + 2] == 0);
  }
  CHECK(exact > 100);
}
