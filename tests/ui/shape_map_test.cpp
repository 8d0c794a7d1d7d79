// The map: seen, hovered, clicked, selected on by rectangle and lasso; its sliders find shapes.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "tests/ui/made_project.h"
#include "tests/ui/test_window.h"
#include "ui/shape_map_mouse.h"
#include "ui/shape_map_paint.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

struct MapWindow : TestWindow {
  explicit MapWindow(std::size_t shapes) {
    if (shapes > 0) test::open_made(*this, shapes);
    REQUIRE(run_command(studio(), "show-map"));
    settle();
  }
  ExplorerSelection& selection() { return studio().ui.selection; }
  MapState& map() { return studio().ui.map; }
  Target target(const std::string& name) {
    for (const Target& each : studio().targets)
      if (each.name == name) return each;
    FAIL("there is no " << name);
    return {};
  }
  MapSpace space() {
    const Target all = target("map");
    return {{all.low_x, all.low_y}, {all.high_x, all.high_y}};
  }
  ImVec2 place_of(std::size_t point) {
    return space().at(map(), studio().shape_map.newest->map.points[point]);
  }
  void wheel_over(ImVec2 place, float notches) {
    ImGui::GetIO().MousePos = place;
    frames(2);
    ImGui::GetIO().MouseWheel = notches;
    frames(1);
    ImGui::GetIO().MouseWheel = 0;
    frames(1);
  }
  void press_at(ImVec2 place) {
    ImGui::GetIO().MousePos = place;
    frames(2);
    ImGui::GetIO().MouseDown[0] = true;
    frames();
  }
  void hold(bool ctrl, bool shift = false) {
    ImGui::GetIO().KeyCtrl = ctrl;
    ImGui::GetIO().KeyShift = shift;
    ImGui::GetIO().KeyMods = (ctrl ? ImGuiKeyModFlags_Ctrl : 0) | (shift ? ImGuiKeyModFlags_Shift : 0);
  }
  void drag_over(const Target& what) {
    press_at({what.low_x + 1, what.low_y + 1});
    for (int i = 0; i < 4; ++i)
      move_by((what.high_x - what.low_x - 2) / 4, (what.high_y - what.low_y - 2) / 4);
    let_go();
  }
};

}  // namespace

TEST_CASE("A template in the legend of the map selects its shapes") {
  MapWindow window(36);
  window.click("map:template:0");
  CHECK(window.selection().shapes.size() == 24);
}

TEST_CASE("Neither the legend nor the words of the axes cover the map") {
  for (const bool small : {false, true}) {
    MapWindow window(36);
    if (small) window.studio().settings.left_width = window.studio().settings.right_width = 420;
    window.frames(4);
    const Target map = window.target("map");
    std::size_t lines = 0;
    for (const Target& each : window.studio().targets) {
      if (!each.name.starts_with("map:template:")) continue;
      CHECK(each.high_y <= map.low_y);
      ++lines;
    }
    CHECK(lines > 0);
    const float axes = axes_height(*window.studio().shape_map.newest);
    CHECK(axes > 2 * ImGui::GetFontSize());
    for (const Target& each : window.studio().targets)
      if (each.name.starts_with("near:")) CHECK(each.low_y > map.high_y);
    // All shapes lie inside when the whole map is shown.
    const MadeMap& made = *window.studio().shape_map.newest;
    const MapSpace space{{map.low_x, map.low_y}, {map.high_x, map.high_y}};
    for (const MapPoint& point : made.map.points) {
      const ImVec2 at = space.at(window.studio().ui.map, point);
      CHECK(at.y > map.low_y);
      CHECK(at.y < map.high_y);
    }
  }
}

TEST_CASE("A shape on the map is hovered, clicked and shown; all panels have it") {
  MapWindow window(36);
  window.studio().settings.map_pictures = false;
  window.frames(2);
  const MapPoint& point = window.studio().shape_map.newest->map.points[7];
  window.press_at(window.place_of(7));
  CHECK(window.selection().hovered == point.shape);
  window.let_go();
  CHECK(window.selection().shapes == std::vector<ShapeId>{point.shape});
  CHECK(window.studio().ui.shape == point.shape);
  // Another one beside it with Ctrl, and out again.
  const ShapeId other = window.studio().shape_map.newest->map.points[20].shape;
  for (const std::size_t selected : {2u, 1u}) {
    window.hold(true);
    window.press_at(window.place_of(20));
    window.let_go();
    window.hold(false);
    CHECK(window.selection().shapes.size() == selected);
  }
  CHECK_FALSE(is_selected(window.selection(), other));
  CHECK(window.studio().ui.shape == point.shape);
}

TEST_CASE("A rectangle and a lasso select what is inside, Ctrl adds, a click beside lets go") {
  MapWindow window(36);
  window.drag_over(window.target("map"));
  CHECK(window.selection().shapes.size() == 36);
  window.press_at({window.target("map").high_x - 4, window.target("map").low_y + 4});
  window.let_go();
  CHECK(window.selection().shapes.empty());
  // A small one about one shape, then another added.
  const auto about = [&](std::size_t point) {
    const ImVec2 at = window.place_of(point);
    return Target{"", at.x - 6, at.y - 6, at.x + 6, at.y + 6};
  };
  window.drag_over(about(3));
  const std::size_t first = window.selection().shapes.size();
  CHECK(is_selected(window.selection(), window.studio().shape_map.newest->map.points[3].shape));
  CHECK(first < 36);
  window.hold(true);
  window.drag_over(about(31));
  window.hold(false);
  CHECK(is_selected(window.selection(), window.studio().shape_map.newest->map.points[3].shape));
  CHECK(is_selected(window.selection(), window.studio().shape_map.newest->map.points[31].shape));

  REQUIRE(run_command(window.studio(), "map-lasso"));
  const Target all = window.target("map");
  window.press_at({all.low_x + 2, all.low_y + 2});
  window.move_by(all.high_x - all.low_x - 4, 0);
  window.move_by(0, all.high_y - all.low_y - 4);
  window.let_go();  // a triangle: what is in its half
  std::vector<ShapeId> expected;
  for (std::size_t i = 0; i < 36; ++i) {
    const ImVec2 at = window.place_of(i);
    const float share =
        (at.x - all.low_x) / (all.high_x - all.low_x) - (at.y - all.low_y) / (all.high_y - all.low_y);
    if (share > 0.02f) expected.push_back(window.studio().shape_map.newest->map.points[i].shape);
  }
  for (const ShapeId shape : expected) CHECK(is_selected(window.selection(), shape));
  CHECK(window.selection().shapes.size() < 36);
}

TEST_CASE("The wheel zooms about the cursor, Shift pans, F shows the whole map again") {
  MapWindow window(36);
  const double zoom = window.map().zoom;
  const ImVec2 before = window.place_of(10);
  window.wheel_over(before, 4);
  CHECK(window.map().zoom > 1.5 * zoom);
  CHECK(window.place_of(10).x == doctest::Approx(before.x).epsilon(0.01));
  CHECK(window.place_of(10).y == doctest::Approx(before.y).epsilon(0.01));
  window.hold(false, true);
  window.press_at(before);
  window.move_by(30, -20);
  window.let_go();
  window.hold(false);
  CHECK(window.place_of(10).x == doctest::Approx(before.x + 30).epsilon(0.01));
  CHECK(window.selection().shapes.empty());
  window.key("F");
  window.frames(2);
  CHECK(window.map().zoom == doctest::Approx(zoom));
}

TEST_CASE("A map that is shown whole fills a view of another size, and one that was zoomed stays as it is") {
  MapWindow window(36);
  const double low = window.map().zoom;
  REQUIRE(run_command(window.studio(), "map-sliders"));
  REQUIRE(run_command(window.studio(), "bottom-panel"));
  window.frames(3);
  const double high = window.map().zoom;
  CHECK(high > 1.05 * low);
  window.wheel_over(window.place_of(10), 1);
  const double zoomed = window.map().zoom;
  CHECK(zoomed > 1.1 * high);
  REQUIRE(run_command(window.studio(), "map-sliders"));
  REQUIRE(run_command(window.studio(), "bottom-panel"));
  window.frames(3);
  CHECK(window.map().zoom == zoomed);
}

TEST_CASE("The map is found as it was left, whatever keys were pressed in views without a camera") {
  MapWindow window(36);
  window.wheel_over(window.place_of(10), 4);
  const MapState left = window.map();
  for (const char* view : {"show-clusters", "show-plots", "show-cloud", "show-inspect", "show-shape"}) {
    REQUIRE(run_command(window.studio(), view));
    window.settle();
    for (const char* key : {"F", "1", "Home"}) window.key(key);
    window.frames(2);
    REQUIRE(run_command(window.studio(), "show-map"));
    window.settle();
    CAPTURE(view);
    CHECK(window.map().x == left.x);
    CHECK(window.map().y == left.y);
    CHECK(window.map().zoom == left.zoom);
  }
}

TEST_CASE("Sliders move the boxes that are wished and find the shapes that have them") {
  MapWindow window(36);
  const std::vector<NearShape> average = window.map().slider.nearest;
  CHECK(average.size() == 12);
  REQUIRE(window.has("wish:1"));
  window.drag("wish:1", 60, 0);  // the seat higher
  window.settle();
  const auto& wish = window.map().slider.wishes.at(0)[1];
  REQUIRE(wish);
  CHECK(*wish > 0.5);
  const std::vector<NearShape> nearest = window.map().slider.nearest;
  CHECK_FALSE(nearest == average);
  CHECK(nearest ==
        nearest_shapes(*window.studio().shape_map.newest->table, 0, window.map().slider.wishes, 12));
  const auto name = [&](ShapeId shape) {
    return window.studio().collection.rows()[*find_row(window.studio().collection, shape)].name;
  };
  window.click("near:" + name(nearest[0].shape));
  CHECK(window.studio().ui.shape == nearest[0].shape);
  CHECK(window.selection().shapes == std::vector<ShapeId>{nearest[0].shape});
  window.click("wish:any:1");
  CHECK_FALSE(window.map().slider.wishes.at(0)[1]);
  REQUIRE(run_command(window.studio(), "wish", std::vector<std::string>{"chair back", "width", "-2"}));
  window.frames(2);
  CHECK(window.map().slider.wishes.at(1)[3] == -2.0);
  CHECK(window.selection().part->part == 1);
  window.click("wish:reset");
  CHECK(window.map().slider.nearest.size() == 12);
  CHECK(std::ranges::all_of(window.map().slider.wishes, is_any));
  CHECK_FALSE(run_command(window.studio(), "wish", std::vector<std::string>{"wheel", "x", "1"}));
  CHECK_FALSE(run_command(window.studio(), "wish", std::vector<std::string>{"chair back", "colour", "1"}));
}

TEST_CASE("Ten thousand shapes on the map are fluid, also while the mouse moves over them") {
  MapWindow window(10'000);
  ImGui::GetIO().MousePos = {600, 300};
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t used = std::clock();
  constexpr int drawn = 20;
  for (int i = 0; i < drawn; ++i) window.move_by(2, 1);
  const double each =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() / drawn;
  MESSAGE("a frame of the map of 10,000 shapes: ", each, " ms; of processors, OpenGL included: ",
          1000.0 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / drawn, " ms");
  CHECK(each < 500);  // a bound for a busy machine: a quiet one takes a tenth of it
}
