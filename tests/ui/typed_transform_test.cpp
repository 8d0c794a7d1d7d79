// G, S and R by keys and mouse, in the window; snapping by what it makes of boxes.
#include "ui/typed_transform.h"

#include <doctest/doctest.h>

#include <numbers>

#include "tests/ui/test_window.h"
#include "ui/selection.h"
#include "ui/snapping.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

const TemplatePart& part(TestWindow& window, std::size_t index) {
  return window.studio().history.current().active_template()->parts[index];
}

void keys(TestWindow& window, std::initializer_list<const char*> pressed) {
  for (const char* key : pressed) window.key(key);
}

void check(const Vec3& a, const Vec3& b) {
  CAPTURE(a.transpose());
  CHECK((a - b).norm() < 1e-9);
}

struct Prepared : TestWindow {
  Prepared() {
    make_template();
    click("part:seat");
    before = studio().history.current();
    steps = studio().history.entries().size();
  }
  Document before;
  std::size_t steps = 0;
};

}  // namespace

TEST_CASE("G, an axis and a number move the box; Enter keeps it as one step") {
  Prepared window;
  keys(window, {"G", "X", "0", ".", "2", "5", "Enter"});
  check(part(window, 0).position.mean, {0.25, -0.1, 0.1});
  CHECK_FALSE(window.studio().ui.transform);
  CHECK(window.studio().history.entries().size() == window.steps + 1);
  CHECK(window.studio().history.entries().back().message == "Move seat");
  window.key("Ctrl+Z");
  CHECK(window.studio().history.current() == window.before);
}

TEST_CASE("digits, signs and Backspace correct the number while it is shown live") {
  Prepared window;
  keys(window, {"G", "Y", "7", "5"});
  check(part(window, 0).position.mean, {0, 74.9, 0.1});
  keys(window, {"Backspace", "Backspace", "1", "-"});
  check(part(window, 0).position.mean, {0, -1.1, 0.1});
  CHECK(window.studio().history.has_preview());
  CHECK(transform_text(*window.studio().ui.transform, window.studio().ui.transform->now) ==
        "Move along y:  -1_");
  window.key("Z");
  check(part(window, 0).position.mean, {0, -0.1, -0.9});
  window.key("Escape");
  CHECK(window.studio().history.current() == window.before);
  CHECK(window.studio().history.entries().size() == window.steps);
  CHECK(window.studio().ui.part == 0);
}

TEST_CASE("S scales all sides or one, R turns by degrees") {
  Prepared window;
  keys(window, {"S", "2", "Enter"});
  check(part(window, 0).scale.mean, {1.2, 0.16, 1.2});
  keys(window, {"S", "Z", "0", ".", "5", "Enter"});
  check(part(window, 0).scale.mean, {1.2, 0.16, 0.6});
  keys(window, {"R", "Y", "9", "0", "Enter"});
  CHECK(part(window, 0).orientation.angularDistance(
            Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()))) < 1e-9);
  CHECK(window.studio().history.entries().size() == window.steps + 3);
  keys(window, {"S", "0", "Enter"});
  CHECK(part(window, 0).scale.mean.minCoeff() > 0);
}

TEST_CASE("several boxes are moved, scaled and turned about their common middle") {
  Prepared window;
  window.key("Ctrl+A");
  keys(window, {"G", "X", "1", "Enter"});
  check(part(window, 0).position.mean, {1, -0.1, 0.1});
  check(part(window, 2).position.mean, {1.5, -0.8, 0.5});
  const Vec3 middle = held_box(selected_boxes(window.studio()))->centre;
  keys(window, {"S", "2", "Enter"});
  check(part(window, 2).position.mean, middle + 2 * (Vec3(1.5, -0.8, 0.5) - middle));
  check(part(window, 2).scale.mean, {0.14, 1.2, 0.14});
  CHECK(window.studio().history.entries().size() == window.steps + 2);
}

TEST_CASE("without a number the boxes follow the mouse; a click keeps, the right button puts back") {
  Prepared window;
  ImGuiIO& io = ImGui::GetIO();
  Target view{};
  for (const Target& target : window.studio().targets)
    if (target.name == "viewport") view = target;
  io.MousePos = {(view.low_x + view.high_x) / 2, (view.low_y + view.high_y) / 2};
  window.frames(2);
  window.key("G");
  window.key("Y");
  window.move_by(0, -60);
  window.frames(2);
  const Vec3 moved = part(window, 0).position.mean;
  CHECK(moved.y() > 0);
  CHECK(moved.x() == 0);
  io.MouseDown[0] = true;
  window.frames();
  window.let_go();
  CHECK_FALSE(window.studio().ui.transform);
  CHECK(window.studio().ui.part == 0);
  check(part(window, 0).position.mean, moved);
  CHECK(window.studio().history.entries().size() == window.steps + 1);
  window.key("R");
  window.move_by(80, 20);
  window.frames(2);
  CHECK(window.studio().history.has_preview());
  io.MouseDown[1] = true;
  window.frames();
  io.MouseDown[1] = false;
  window.frames(2);
  CHECK_FALSE(window.studio().ui.transform);
  CHECK_FALSE(window.studio().history.has_preview());
  check(part(window, 0).position.mean, moved);
}

TEST_CASE("undo, a deleted part and another selection end a transform") {
  for (const char* key : {"Ctrl+Z", "Delete", "Tab"}) {
    CAPTURE(key);
    Prepared window;
    keys(window, {"G", "X", "1"});
    window.key(key);
    window.frames(2);
    if (std::string(key) == "Tab") continue;  // refused while something is dragged
    CHECK_FALSE(window.studio().ui.transform);
    CHECK_FALSE(window.studio().history.has_preview());
  }
}

TEST_CASE("a box that is moved snaps with faces and middle, along what the handle may move only") {
  const std::vector<SnapPlane> planes{{0, 1, "a", false}, {1, -1, "ground", false}, {0, 0, "middle", true}};
  const Box start{{0.3, 0, 0}, {0.5, 0.5, 0.5}};
  Box box = start;
  box.centre = {0.46, -0.48, 0.2};
  const BoxDrag free{{HandleKind::move_view, 0, {}}, start, {}};
  Snapped result = snapped(box, free, {}, planes, 0.05);
  check(result.box.centre, {0.5, -0.5, 0.2});
  CHECK(result.planes.size() == 2);
  CHECK(snapped(box, free, {}, planes, 0.01).planes.empty());
  const BoxDrag along{{HandleKind::move_axis, 1, {}}, start, {}};
  check(snapped(box, along, {}, planes, 0.05).box.centre, {0.46, -0.5, 0.2});
  const BoxDrag plane{{HandleKind::move_plane, 1, {}}, start, {}};
  check(snapped(box, plane, {}, planes, 0.05).box.centre, {0.5, -0.48, 0.2});
  box.centre.x() = -0.03;
  check(snapped(box, free, {}, planes, 0.05).box.centre, {0, -0.5, 0.2});
}

TEST_CASE("a face that is resized snaps, and the other side stays") {
  const std::vector<SnapPlane> planes{{0, 1, "a", false}};
  const Box start{{0.3, 0, 0}, {0.5, 0.5, 0.5}};
  Box box = start;
  box.centre.x() = 0.38;
  box.half_extent.x() = 0.58;
  const BoxDrag drag{{HandleKind::resize, 0, {1, 1, 0}}, start, {}};
  Snapped result = snapped(box, drag, {}, planes, 0.05);
  check(result.box.to_world({-1, 0, 0}), {-0.2, 0, 0});
  check(result.box.to_world({1, 0, 0}), {1, 0, 0});
  box = start;
  box.half_extent.x() = 0.68;
  result = snapped(box, drag, {.about_centre = true}, planes, 0.05);
  check(result.box.centre, start.centre);
  check(result.box.to_world({1, 0, 0}), {1, 0, 0});
}

TEST_CASE("a corner snaps with the face that is nearest to a plane, in proportion") {
  const std::vector<SnapPlane> planes{{0, 1, "a", false}, {1, 0.61, "b", false}};
  const Box start{{0.3, 0, 0}, {0.5, 0.5, 0.25}};
  Box box{{0.38, 0.08, 0.04}, {0.58, 0.58, 0.29}};  // dragged out to 0.96, 0.66, 0.33
  const BoxDrag drag{{HandleKind::resize, 0, {1, 1, 1}}, start, {}};
  Snapped result = snapped(box, drag, {}, planes, 0.05);
  REQUIRE(result.planes.size() == 1);
  CHECK(result.planes[0].name == "a");
  check(result.box.to_world({-1, -1, -1}), start.to_world({-1, -1, -1}));
  CHECK(result.box.to_world({1, 1, 1}).x() == doctest::Approx(1));
  check(result.box.half_extent / result.box.half_extent.x(), start.half_extent / start.half_extent.x());
  box.centre = start.centre;
  box.half_extent = 1.38 * start.half_extent;
  result = snapped(box, drag, {.about_centre = true}, planes, 0.05);
  check(result.box.centre, start.centre);
  CHECK(result.box.to_world({1, 1, 1}).x() == doctest::Approx(1));
  CHECK(snapped(box, drag, {}, planes, 0.005).planes.empty());
}

TEST_CASE("a box that is turned snaps to steps of 15 degrees, and to stand straight") {
  const double degree = std::numbers::pi / 180;
  const auto turned = [&](double degrees) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * degree, Vec3::UnitY()));
  };
  Box start;
  start.orientation = turned(7);
  const BoxDrag drag{{HandleKind::rotate, 1, {}}, start, {}};
  const auto after = [&](double degrees) {
    Box box = start;
    box.orientation = turned(degrees) * start.orientation;
    return snapped(box, drag, {}, {}, 0);
  };
  CHECK(after(43).box.orientation.angularDistance(turned(52)) < 1e-9);
  CHECK(*after(43).turned_degrees == doctest::Approx(45));
  CHECK(after(-6).box.orientation.angularDistance(turned(0)) < 1e-9);
  CHECK(after(85).box.orientation.angularDistance(turned(90)) < 1e-9);
  CHECK_FALSE(after(38).turned_degrees);
  CHECK(after(38).box.orientation.angularDistance(turned(45)) < 1e-9);
}

TEST_CASE("the planes to snap to are those of the other boxes and the middle; what moves along is left out") {
  TestWindow window;
  window.make_template();
  window.click("part:leg");
  window.click("command:mirror-part");
  window.key("G");
  bool ground = false;
  for (const SnapPlane& plane : window.studio().viewport.snap_planes) {
    CHECK(plane.name.find("leg") == std::string::npos);
    if (plane.name == "top of seat") {
      ground = true;
      CHECK(plane.at == doctest::Approx(-0.02));
    }
  }
  CHECK(ground);
}
