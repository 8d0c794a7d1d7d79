// The four views, clicked and dragged in.
#include "ui/view_panes.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/ui/viewport_window.h"
#include "ui/command.h"
#include "ui/edit_overlay.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// The four views at once; what is pressed is pressed in the pane.
struct FourViews : Window {
  FourViews() {
    studio.ui.part = 1;
    run_command(studio, "four-views");
    frames(2);
    for (ViewPane& pane : state.panes) frame(pane.camera, {400, 300}, {-1.5, -1, -1}, {1.5, 1, 1});
    frames(3);
  }
  Target target(const std::string& name) const {
    for (const Target& each : studio.targets)
      if (each.name == name) return each;
    FAIL(name << " was not drawn");
    return {};
  }
  Target area_of(std::size_t pane) const {
    return target(pane == 0 ? "viewport" : "viewport:" + std::to_string(pane));
  }
  glm::dvec2 screen_of(std::size_t pane, const Vec3& place) const {
    const Target t = area_of(pane);
    const Viewport size{static_cast<int>(t.high_x - t.low_x), static_cast<int>(t.high_y - t.low_y)};
    return glm::dvec2(t.low_x, t.low_y) + *to_screen(state.panes[pane].camera, size, to_glm(place));
  }
  void mouse_at(const glm::dvec2& at) {
    io.MousePos = {static_cast<float>(at.x), static_cast<float>(at.y)};
    frames(2);
  }
  void drag_on_screen(const glm::dvec2& from, const glm::dvec2& to) {
    mouse_at(from);
    io.MouseDown[0] = true;
    frames(1);
    for (const double t : {0.3, 0.6, 1.0}) mouse_at(glm::mix(from, to, t));
    io.MouseDown[0] = false;
    frames(1);
  }
  void click_target(const std::string& name) {
    const Target t = target(name);
    drag_on_screen({(t.low_x + t.high_x) / 2, (t.low_y + t.high_y) / 2},
                   {(t.low_x + t.high_x) / 2, (t.low_y + t.high_y) / 2});
    frames(2);
  }
};

}  // namespace

TEST_CASE("a box is dragged in each of the four views, and is the same in all") {
  FourViews w;
  const std::size_t steps = w.steps();
  struct Case {
    PaneKind pane;
    Vec3 side;  // the face that is pulled by 0.2 outwards
  };
  std::size_t count = 0;
  for (const auto& [pane, side] :
       {Case{PaneKind::top, Vec3(0, 0, 1)}, Case{PaneKind::front, Vec3(1, 0, 0)},
        Case{PaneKind::right, Vec3(0, 1, 0)}, Case{PaneKind::perspective, Vec3(1, 0, 0)}}) {
    const auto index = static_cast<std::size_t>(pane);
    CAPTURE(index);
    const Box before = w.box(1);
    const Vec3 face = before.to_world(side);
    w.drag_on_screen(w.screen_of(index, face), w.screen_of(index, face + 0.2 * side));
    CHECK(w.state.current == index);
    CHECK(w.steps() == steps + ++count);
    CHECK((w.box(1).half_extent - before.half_extent).dot(side) == doctest::Approx(0.1).epsilon(0.1));
    CHECK((w.box(1).to_world(-side) - before.to_world(-side)).norm() < 1e-9);
    for (const ViewPane& other : w.state.panes) {
      REQUIRE(other.drawn);
      CHECK(other.drawn->document_revision == w.studio.history.revision());
    }
  }
}

TEST_CASE("boxes are picked in each of the four views; only the one in perspective turns") {
  FourViews w;
  for (const std::size_t pane : {1, 2, 0}) {
    const std::size_t part = pane == 2 ? 1 : 0;
    const glm::dvec2 at = w.screen_of(pane, w.box(part).to_world(Vec3(0.6, 0.6, 0.6)));
    w.studio.ui.part.reset();
    w.frames(1);
    w.drag_on_screen(at, at);
    CHECK(w.studio.ui.part == part);
  }
  w.studio.ui.part.reset();
  w.frames(1);
  for (std::size_t pane = 0; pane < pane_count; ++pane) {
    const Target t = w.area_of(pane);
    const auto cameras = [&] {
      std::vector<Camera> all;
      for (const ViewPane& each : w.state.panes) all.push_back(each.camera);
      return all;
    };
    const std::vector<Camera> before = cameras();
    w.drag_on_screen({t.low_x + 12, t.high_y - 90}, {t.low_x + 50, t.high_y - 70});
    std::vector<Camera> after = cameras();
    CHECK((after[pane].yaw != before[pane].yaw) == (pane == 0));
    CHECK((after[pane].target != before[pane].target) == (pane != 0));
    w.io.MouseWheel = 1;
    w.frames(1);
    w.io.MouseWheel = 0;
    after = cameras();
    CHECK(after[pane].distance < before[pane].distance);
    for (std::size_t other = 0; other < pane_count; ++other)
      if (other != pane) CHECK(after[other] == before[other]);
  }
}

TEST_CASE("a click on the name of a view makes it large, and brings all four back") {
  FourViews w;
  for (const char* name : {"Top", "Perspective"}) {
    w.click_target(std::string("pane:") + name);
    CHECK_FALSE(w.studio.ui.view.four_views);
    CHECK(w.state.shown == std::vector<std::size_t>{w.state.current});
    const Target large = w.area_of(w.state.current);
    CHECK(large.high_x - large.low_x > 500);
    w.click_target(std::string("pane:") + name);
    CHECK(w.studio.ui.view.four_views);
    CHECK(w.state.shown.size() == pane_count);
  }
  // A command that looks from somewhere brings the view that can into sight.
  w.click_target("pane:Front");
  run_command(w.studio, "view-left");
  w.frames(2);
  CHECK(w.state.current == 0);
}

TEST_CASE("The name of the first view says whether it is in perspective") {
  FourViews w;
  CHECK(std::string(pane_title(w.studio, 0)) == "Perspective");
  run_command(w.studio, "orthographic");
  w.frames(2);
  CHECK(std::string(pane_title(w.studio, 0)) == "Orthographic");
  CHECK(std::string(pane_title(w.studio, 1)) == "Top");
  run_command(w.studio, "orthographic");
  CHECK(std::string(pane_title(w.studio, 0)) == "Perspective");
}

TEST_CASE("What a tool says stands in the middle, and beside the name of the view where that is in its way") {
  const GizmoView view{{}, {600, 400}, 1};
  const auto place = [&](float name_from, float width) {
    return strip_place({100, 50}, view, {{name_from, 56}, {694, 76}}, {width, 16});
  };
  CHECK(place(620, 300).low.x + place(620, 300).high.x == 2 * 400);
  CHECK(place(620, 480).high.x == 614);
  CHECK(place(150, 480).low.x == 106);  // nowhere is enough room: it begins at the edge
}
