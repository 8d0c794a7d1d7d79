// The strip of other shapes: really clicked, and following a drag.
#include "ui/shape_strip.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/fitting/fit_template.h"
#include "core/session/actions.h"
#include "tests/ui/test_window.h"
#include "ui/project_actions.h"

using namespace archetype;
using test::TestWindow;

namespace {

void run(TestWindow& window, const char* command, std::vector<std::string> arguments = {}) {
  REQUIRE(run_command(window.studio(), command, arguments));
  window.settle();
}

std::vector<ShapeId> members(TestWindow& window) {
  return window.studio().ui.strip.shapes;
}

std::string name_of(TestWindow& window, std::size_t tile) {
  return window.studio().strip.tiles[tile].shape->record.name;
}

}  // namespace

TEST_CASE("The strip fills itself once it is in sight, and every tile is fitted and drawn") {
  TestWindow window;
  window.open_chairs(12);
  window.make_template();
  CHECK(members(window).empty());  // it costs nothing while nobody looks
  window.click("tab:Other shapes");
  window.settle();
  REQUIRE(members(window).size() == most_strip_shapes);
  CHECK(std::ranges::count(members(window), *window.studio().ui.shape) == 0);
  for (const StripTile& tile : window.studio().strip.tiles) {
    REQUIRE(tile.fit);
    CHECK(tile.drawn.has_value());
    CHECK(tile.drawn->fit == tile.fit);
    CHECK_FALSE(energy_change(tile));  // nothing was edited since
    const auto alone =
        fit_template(*window.studio().history.current().active_template(), *tile.shape->samples, {});
    CHECK(tile.fit->view.fit.energy.total() == doctest::Approx(alone->energy.total()));
    CHECK(tile.fit->colours.elements->size() == tile.shape->display.mesh->triangle_count());
  }
}

TEST_CASE("While a box is dragged all tiles follow, and say how far they have changed since it began") {
  TestWindow window;
  window.open_chairs(6);
  window.make_template();
  window.studio().ui.part = 1;
  window.click("tab:Other shapes");
  window.settle();
  const std::vector<StripTile>& tiles = window.studio().strip.tiles;
  std::vector<double> before;
  for (const StripTile& tile : tiles) before.push_back(energy_without_missing(tile.fit->view).total());
  run(window, "clear-latency");
  run(window, "drag-part", {"0", "0.6", "0", "12"});
  CHECK(window.studio().strip.latency.milliseconds().size() == 12);  // every edit was answered
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double now = energy_without_missing(tiles[i].fit->view).total();
    REQUIRE(energy_change(tiles[i]));
    CHECK(*energy_change(tiles[i]) == doctest::Approx(now - before[i]));
    CHECK(*tiles[i].fit->view.part_template == *window.studio().history.current().active_template());
  }
  // The next drag is counted from where this one ended.
  run(window, "drag-part", {"0", "-0.6", "0", "4"});
  for (std::size_t i = 0; i < tiles.size(); ++i)
    CHECK(energy_without_missing(tiles[i].fit->view).total() - *energy_change(tiles[i]) !=
          doctest::Approx(before[i]));
}

TEST_CASE("A tile is clicked into view, taken out, and put back; the worst are those with the most energy") {
  TestWindow window;
  window.open_chairs(12);
  window.make_template();
  run(window, "fit-all");
  run(window, "strip-worst");
  const auto energy_of = [&](ShapeId id) {
    const auto& rows = window.studio().collection.rows();
    return rows[*find_row(window.studio().collection, id)].fit->energy.total();
  };
  const std::vector<ShapeId> worst = members(window);
  REQUIRE(worst.size() == most_strip_shapes);
  for (const ShapeRow& row : window.studio().collection.rows())
    if (row.id != *window.studio().ui.shape && std::ranges::count(worst, row.id) == 0)
      CHECK(row.fit->energy.total() <= energy_of(worst.back()));

  const std::string name = name_of(window, 2);
  window.click("tile:" + name);
  window.settle();
  CHECK(window.studio().ui.shape == worst[2]);
  CHECK(members(window) == worst);
  window.click("tile-out:" + name);
  window.settle();
  CHECK(members(window).size() == most_strip_shapes - 1);
  window.click("command:strip-add");
  window.settle();
  CHECK(members(window).back() == worst[2]);
  CHECK_FALSE(run_command(window.studio(), "strip-add"));  // it is there, and the strip is full
  window.click("command:strip-random");
  window.settle();
  const std::vector<ShapeId> random = members(window);
  window.click("command:strip-random");
  window.settle();
  CHECK(members(window) != random);
  window.click("command:strip-clear");
  window.settle();
  CHECK(members(window).empty());
  window.click("tab:Jobs");
  window.click("tab:Other shapes");
  window.settle();
  CHECK(members(window).empty());  // it was emptied by hand
}

TEST_CASE("Of a collection that is closed no tile stays") {
  TestWindow window;
  window.open_chairs(3);
  window.make_template();
  run(window, "strip");
  REQUIRE(members(window).size() == 2);
  run(window, "strip-add");
  CHECK(members(window).size() == 3);
  window.studio().collection = {};
  window.frames(3);
  CHECK(members(window).empty());
  CHECK(window.studio().strip.tiles.empty());
}

TEST_CASE("A project that is opened again has its shapes in the strip") {
  TestWindow window;
  window.open_chairs(4);
  window.make_template();
  Studio& studio = window.studio();
  const std::filesystem::path path = studio.collection.path;
  const std::vector<ShapeId> chosen{studio.collection.rows()[3].id, studio.collection.rows()[1].id};
  for (const ShapeId id : chosen) add_to_strip(studio, id);
  window.settle();
  CHECK(read_strip(Project::open(path)) == chosen);
  const std::filesystem::path copy = window.scratch().path() / "copy.archetype";
  save_project_as(studio, copy);
  window.settle();
  CHECK(studio.ui.strip.shapes == chosen);
  clear_strip(studio);
  save_now(studio);
  CHECK(read_strip(Project::open(copy)).empty());
  open_project(studio, path);
  window.settle();
  CHECK(studio.ui.strip.shapes == chosen);
  Project::open(path).set_setting("studio.strip", "999 x 1 1");
  CHECK(read_strip(Project::open(path)).empty());
}
