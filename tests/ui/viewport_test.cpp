// The viewport through Dear ImGui's own hit testing: the mouse is set, frames are drawn, the document is
// compared.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "tests/ui/viewport_window.h"
#include "ui/command.h"
#include "ui/headless_window.h"
#include "ui/selection.h"

using namespace archetype;
using namespace archetype::test;

namespace {

constexpr std::array<int, 3> high_x{1, 0, 0};

}  // namespace

TEST_CASE("a click selects the box, a click on empty space nothing") {
  Window w;
  w.click(w.pixel_of(w.box(1).centre));
  CHECK(w.studio.ui.part == std::size_t{1});
  w.click(w.pixel_of(w.box(0).centre));
  CHECK(w.studio.ui.part == std::size_t{0});
  w.click({20, 20});
  CHECK_FALSE(w.studio.ui.part);
  CHECK(w.steps() == 2);
}

TEST_CASE("clicking again takes the next box below the cursor") {
  Window w;
  Box inner = w.box(1);
  inner.half_extent *= 0.4;
  const std::size_t part = add_part(w.studio.history, inner);
  const glm::dvec2 at = w.pixel_of(inner.centre + Vec3(0.05, 0.05, 0));
  w.studio.ui.tool = BoxTool::rotate;  // no handle in the middle
  for (const std::size_t expected : {std::size_t{1}, part, std::size_t{1}}) {
    w.click(at);
    CHECK(w.studio.ui.part == expected);
  }
}

TEST_CASE("a face is dragged against the opposite one: live edits, then one step") {
  Window w;
  w.studio.ui.part = 1;
  w.frames(1);
  const Box before = w.box(1);
  const std::size_t steps = w.steps();
  const glm::dvec2 from = w.pixel_of(before.to_world(Vec3(1, 0, 0)));
  const glm::dvec2 to = w.pixel_of(before.to_world(Vec3(1, 0, 0)) + Vec3(0.3, 0, 0));
  REQUIRE(w.handle_at(from) == Handle{HandleKind::resize, 0, high_x});
  w.press(from);
  w.move_to(glm::mix(from, to, 0.5));
  CHECK(w.studio.history.has_preview());
  CHECK(w.box(1).half_extent.x() > before.half_extent.x() + 0.05);
  CHECK(w.steps() == steps);
  w.move_to(to);
  w.release();
  CHECK_FALSE(w.studio.history.has_preview());
  CHECK(w.steps() == steps + 1);
  CHECK(w.box(1).half_extent.x() == doctest::Approx(before.half_extent.x() + 0.15).epsilon(0.02));
  CHECK((w.box(1).to_world(Vec3(-1, 0, 0)) - before.to_world(Vec3(-1, 0, 0))).norm() < 1e-9);
  CHECK(same(w.box(0), two_boxes().parts[0].mean_box()));
  CHECK(w.studio.history.undo());
  CHECK(same(w.box(1), before));
}

TEST_CASE("Alt resizes about the centre") {
  Window w;
  w.studio.ui.part = 1;
  w.frames(1);
  const Box before = w.box(1);
  w.io.KeyAlt = true;
  w.drag(w.pixel_of(before.to_world(Vec3(1, 0, 0))), w.pixel_of(before.to_world(Vec3(1.5, 0, 0))));
  CHECK((w.box(1).centre - before.centre).norm() < 1e-9);
  CHECK(w.box(1).half_extent.x() == doctest::Approx(1.5 * before.half_extent.x()).epsilon(0.02));
}

TEST_CASE("the middle moves the box, and X, Y and Z keep it to an axis") {
  Window w;
  w.studio.ui.part = 0;
  w.frames(1);
  const Box before = w.box(0);
  const glm::dvec2 from = w.pixel_of(before.centre);
  w.press(from);
  w.move_to(from + glm::dvec2(40, -90));
  CHECK((w.box(0).centre - before.centre).norm() > 0.1);
  REQUIRE(run_command(w.studio, "axis-y"));
  w.frames(1);
  w.release();
  const Vec3 way = w.box(0).centre - before.centre;
  CHECK(way.x() == doctest::Approx(0));
  CHECK(way.z() == doctest::Approx(0));
  CHECK(way.y() > 0.1);
  CHECK(w.box(0).half_extent == before.half_extent);
}

TEST_CASE("keeping to an axis needs a drag, and a second press lets go") {
  Window w;
  CHECK_FALSE(run_command(w.studio, "axis-x"));
  w.studio.ui.part = 0;
  w.frames(1);
  w.press(w.pixel_of(w.box(0).centre));
  CHECK(run_command(w.studio, "axis-x"));
  CHECK(w.studio.ui.drag_axis == 0);
  CHECK(run_command(w.studio, "axis-x"));
  CHECK_FALSE(w.studio.ui.drag_axis);
  w.release();
}

TEST_CASE("Esc while dragging puts the box back, and the rest of the drag does nothing") {
  Window w;
  w.studio.ui.part = 1;
  w.frames(1);
  const Box before = w.box(1);
  const std::size_t steps = w.steps();
  const glm::dvec2 from = w.pixel_of(before.centre);
  w.press(from);
  w.move_to(from + glm::dvec2(60, 10));
  REQUIRE(w.studio.history.has_preview());
  run_command(w.studio, "cancel");
  w.move_to(from + glm::dvec2(120, 40));
  CHECK_FALSE(w.studio.history.has_preview());
  CHECK(same(w.box(1), before));
  w.release();
  CHECK(w.steps() == steps);
  CHECK(w.studio.ui.part == std::size_t{1});
}

TEST_CASE("undo while dragging ends the drag") {
  Window w;
  w.studio.ui.part = 1;
  w.frames(1);
  const glm::dvec2 from = w.pixel_of(w.box(1).centre);
  w.press(from);
  w.move_to(from + glm::dvec2(60, 10));
  w.studio.history.undo();
  w.move_to(from + glm::dvec2(90, 10));
  w.release();
  CHECK_FALSE(w.studio.history.has_preview());
  CHECK(w.state.action == MouseAction::none);
}

TEST_CASE("a click on a handle is no edit") {
  Window w;
  w.studio.ui.part = 1;
  w.frames(1);
  const std::size_t steps = w.steps();
  w.click(w.pixel_of(w.box(1).to_world(Vec3(1, 0, 0))));
  CHECK(w.steps() == steps);
  CHECK_FALSE(w.studio.history.has_preview());
  CHECK(w.studio.ui.part == std::size_t{1});
}

TEST_CASE("only the selected box has handles: elsewhere a drag orbits, and edits nothing") {
  Window w;
  w.studio.ui.part = 1;
  w.frames(1);
  const Document before = w.studio.history.current();
  const Camera camera = w.state.pane().camera;
  w.drag(w.pixel_of(w.box(0).to_world(Vec3(-1, 0, 0))), w.pixel_of(w.box(0).centre) - glm::dvec2(120, 40));
  CHECK(w.studio.history.current() == before);
  CHECK(w.state.pane().camera.yaw != camera.yaw);
  CHECK(w.state.pane().camera.target == camera.target);
  CHECK(w.studio.ui.part == std::size_t{1});
}

TEST_CASE("the middle button and Shift pan, so that the scene follows the cursor") {
  for (const bool shift : {false, true}) {
    Window w;
    const Camera before = w.state.pane().camera;
    const glm::dvec2 start = w.pixel_of(to_eigen(before.target));
    w.io.KeyShift = shift;
    w.drag({60, 60}, {160, 110}, shift ? 0 : 2);
    CHECK(glm::length(w.pixel_of(to_eigen(before.target)) - start - glm::dvec2(100, 50)) < 0.5);
    CHECK(w.state.pane().camera.yaw == before.yaw);
  }
}

TEST_CASE("the wheel zooms to the cursor") {
  Window w;
  const Vec3 corner = w.box(1).to_world(Vec3(1, 1, 1));
  const glm::dvec2 at = w.pixel_of(corner);
  w.move_to(at);
  const double distance = w.state.pane().camera.distance;
  w.io.MouseWheel = 2;
  w.frames(2);
  CHECK(w.state.pane().camera.distance < 0.8 * distance);
  CHECK(glm::length(w.pixel_of(corner) - at) < 1);
}

TEST_CASE("views and frames that commands wish for are flown to") {
  Window w;
  run_command(w.studio, "view-right");
  for (int i = 0; i < 1000 && (w.state.pane().flight || i == 0); ++i) w.frames(1);
  Camera right;
  look_from(right, ViewPreset::right);
  CHECK(w.state.pane().camera.yaw == right.yaw);
  CHECK(w.state.pane().camera.pitch == right.pitch);
  w.studio.ui.part = 0;
  run_command(w.studio, "frame");
  for (int i = 0; i < 1000 && (w.state.pane().flight || i == 0); ++i) w.frames(1);
  CHECK(glm::length(w.state.pane().camera.target - to_glm(w.box(0).centre)) < 1e-9);
}

TEST_CASE("the picture is drawn anew only when something changed") {
  Window w;
  for (int i = 0; i < 1000 && viewport_busy(w.state, w.studio.shape.shape_revision); ++i) w.frames(1);
  CHECK(w.state.pane().drawn_fine);
  const auto drawn = w.state.pane().drawn;
  w.frames(3);
  CHECK(w.state.pane().drawn_fine);
  CHECK(w.state.pane().drawn == drawn);
  w.studio.ui.part = 1;
  w.frames(1);
  CHECK_FALSE(w.state.pane().drawn_fine);
}

TEST_CASE("another way to navigate: Blender's buttons") {
  Window w;
  w.studio.settings.navigation = "blender";
  const Camera before = w.state.pane().camera;
  w.drag({60, 60}, {160, 110}, 0);
  CHECK(w.state.pane().camera == before);
  w.drag({60, 60}, {160, 110}, 2);
  CHECK(w.state.pane().camera.yaw != before.yaw);
}

TEST_CASE("Ctrl and click selects several boxes, whose handles move them together as one step") {
  Window w;
  w.click(w.pixel_of(w.box(0).centre));
  w.io.KeyCtrl = true;
  w.click(w.pixel_of(w.box(1).centre));
  w.io.KeyCtrl = false;
  CHECK(selected_parts(w.studio.ui) == PartList{1, 0});
  const std::size_t steps = w.steps();
  const Box first = w.box(0);
  const Box second = w.box(1);
  const glm::dvec2 middle = w.pixel_of(0.5 * (first.centre + second.centre));
  REQUIRE(w.handle_at(middle) == Handle{HandleKind::move_view, 0, {}});
  w.drag(middle, middle + glm::dvec2(60, -30));
  CHECK(w.steps() == steps + 1);
  const Vec3 way = w.box(0).centre - first.centre;
  CHECK(way.norm() > 0.1);
  CHECK((w.box(1).centre - second.centre - way).norm() < 1e-9);
  CHECK(w.box(1).half_extent == second.half_extent);
  w.io.KeyCtrl = true;
  w.click(w.pixel_of(w.box(1).centre + Vec3(0.25, 0, 0)));
  w.io.KeyCtrl = false;
  CHECK(selected_parts(w.studio.ui) == PartList{0});
}

TEST_CASE("the edges around several selected boxes are drawn, and gone with all but one of them") {
  Window w;
  const auto light_at = [&](const Vec3& place) {
    const Target area = w.area();
    const glm::dvec2 pixel = w.pixel_of(place);
    const Picture picture = picture_of_frame();
    int brightest = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      const auto x = static_cast<std::size_t>(area.low_x + pixel.x);
      const auto y = static_cast<std::size_t>(area.low_y + pixel.y + dy);
      const std::size_t at = 4 * (y * static_cast<std::size_t>(picture.width) + x);
      brightest = std::max(
          brightest, std::min({picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]}) + 0);
    }
    return brightest;
  };
  // Between the boxes there is nothing else.
  const std::array<Vec3, 2> places{Vec3(-0.15, 0.5, 0.3), Vec3(-0.15, -0.5, 0.3)};
  w.studio.ui.part = 0;
  w.frames(2);
  for (const Vec3& place : places) CHECK(light_at(place) < 120);
  w.studio.ui.also_selected = {1};
  w.frames(2);
  for (const Vec3& place : places) CHECK(light_at(place) > 180);
  w.studio.ui.also_selected = {};
  w.frames(2);
  for (const Vec3& place : places) CHECK(light_at(place) < 120);
}

TEST_CASE("Ctrl held while dragging snaps to the other box, and what it snaps to is shown") {
  Window w;
  set_part_box(w.studio.history, 1, {{0.7, 0.13, 0}, {0.4, 0.5, 0.3}, Eigen::Quaterniond::Identity()});
  w.studio.ui.part = 1;
  w.frames(2);
  const Box box = w.box(1);
  const glm::dvec2 from = w.pixel_of(box.centre);
  REQUIRE(w.handle_at(from));
  w.press(from);
  w.studio.ui.drag_axis = 1;
  const glm::dvec2 to = w.pixel_of(box.centre - Vec3(0, 0.12, 0));
  w.move_to(to);
  CHECK(std::abs(w.box(1).centre.y()) > 1e-6);
  w.io.KeyCtrl = true;
  w.frames(2);
  CHECK(std::abs(w.box(1).centre.y()) < 1e-9);
  REQUIRE(w.state.snapped);
  CHECK(w.state.snapped->planes[0].name.find("left") != std::string::npos);
  w.release();
  w.io.KeyCtrl = false;
  CHECK_FALSE(w.state.snapped);
  CHECK(std::abs(w.box(1).centre.y()) < 1e-9);
}
