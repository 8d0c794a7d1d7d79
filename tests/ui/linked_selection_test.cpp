// One selection over all views of the explorer: shapes, a part, a place that was pointed at.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "tests/ui/sized_project.h"
#include "tests/ui/test_window.h"
#include "ui/cluster_card.h"
#include "ui/clusters_view.h"
#include "ui/picked_place.h"
#include "ui/plot_selection.h"
#include "ui/plot_sources.h"
#include "ui/project_actions.h"
#include "ui/selection.h"
#include "ui/shape_map_mouse.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

struct ExplorerWindow : TestWindow {
  ExplorerWindow() : TestWindow(960, 640) {
    open_project(studio(), test::make_sized_project(scratch().path(), 9));
    settle();
    run("show-clusters");
    REQUIRE(follow_clusters(studio()).size() >= 2);
  }
  void run(const char* command, const std::vector<std::string>& arguments = {}) {
    CAPTURE(command);
    REQUIRE(run_command(studio(), command, arguments));
    rest();
  }
  // With the mouse where it points at nothing.
  void rest() {
    ImGui::GetIO().MousePos = {-1, -1};
    settle();
  }
  ExplorerSelection& selection() { return studio().ui.selection; }
  const ShapeRow& row(std::size_t i) { return studio().collection.rows()[i]; }
  Target target(const std::string& name) {
    for (const Target& each : studio().targets)
      if (each.name == name) return each;
    FAIL("there is no " << name);
    return {};
  }
  void click_at(ImVec2 place) {
    ImGui::GetIO().MousePos = place;
    frames(3);
    ImGui::GetIO().MouseDown[0] = true;
    frames();
    let_go();
    rest();
  }
  Picture picture() {
    rest();
    return window().picture();
  }
  // Where a point of the cloud is drawn, of those that are in front of all others near them.
  ImVec2 place_of_point(std::size_t point) {
    const Target pane = target("cloud:deformed");
    const CloudView& view = studio().cloud;
    const auto at = to_screen(
        view.camera, {static_cast<int>(pane.high_x - pane.low_x), static_cast<int>(pane.high_y - pane.low_y)},
        glm::dvec3(view.content->points->moved[point]));
    REQUIRE(at);
    return {pane.low_x + static_cast<float>(at->x), pane.low_y + static_cast<float>(at->y)};
  }
  // Clicks points until one has taken its shape and a part.
  void click_cloud_point() {
    run("show-cloud");
    for (std::size_t point = 0; point < studio().cloud.content->of.size(); point += 7) {
      select_only(selection(), {});
      selection().place.reset();
      click_at(place_of_point(point));
      if (selection().place && selection().shapes.size() == 1) return;
    }
    FAIL("no point of the cloud can be clicked");
  }
};

struct Way {
  std::string name;
  std::function<void(ExplorerWindow&)> take;
};

// The picture of a view is another one without what is selected, and the same again with it.
void check_seen_in(ExplorerWindow& window, const char* view, const std::function<void()>& let_go) {
  CAPTURE(view);
  window.run(view);
  const Picture with = window.picture();
  const ExplorerSelection kept = window.selection();
  const auto part = window.studio().ui.part;
  const auto also = window.studio().ui.also_selected;
  let_go();
  CHECK_FALSE(window.picture() == with);
  window.selection() = kept;
  window.studio().ui.part = part;
  window.studio().ui.also_selected = also;
  CHECK(window.picture() == with);
}

}  // namespace

TEST_CASE("A shape that is selected in any view is the selected one in all of them") {
  ExplorerWindow window;
  Studio& studio = window.studio();
  const std::vector<Way> ways{
      {"grid", [](ExplorerWindow& w) { w.click("cell:" + w.row(1).name); }},
      {"clusters",
       [](ExplorerWindow& w) {
         w.run("show-clusters");
         w.run("expand-clusters");
         const auto cell = std::ranges::find_if(
             w.studio().targets, [](const Target& each) { return each.name.starts_with("cluster-cell:"); });
         REQUIRE(cell != w.studio().targets.end());
         w.click(std::string(cell->name));
         w.run("expand-clusters");
       }},
      {"map",
       [](ExplorerWindow& w) {
         w.run("show-map");
         w.run("map-pictures");  // dots
         const Target all = w.target("map");
         const MapPoint& point = w.studio().shape_map.newest->map.points[3];
         w.click_at(MapSpace{{all.low_x, all.low_y}, {all.high_x, all.high_y}}.at(w.studio().ui.map, point));
         w.run("map-pictures");
       }},
      {"nearest to the wishes",
       [](ExplorerWindow& w) {
         w.run("show-map");
         const auto near = std::ranges::find_if(
             w.studio().targets, [](const Target& each) { return each.name.starts_with("near:"); });
         REQUIRE(near != w.studio().targets.end());
         w.click(std::string(near->name));
       }},
      {"cloud", [](ExplorerWindow& w) { w.click_cloud_point(); }},
      {"plots",
       [](ExplorerWindow& w) {
         w.run("show-plot", {"energies"});
         const Figure& figure = *w.studio().ui.plots.figure;
         for (std::size_t panel = 0; panel < figure.panels.size(); ++panel)
           for (std::size_t bin = 0; bin < figure.panels[panel].series[0].shapes.size(); ++bin)
             if (figure.panels[panel].series[0].shapes[bin].size() == 1)
               return w.click("bar:" + std::to_string(panel) + ":0:" + std::to_string(bin));
         FAIL("no bar is of one shape");
       }},
  };
  for (const Way& way : ways) {
    CAPTURE(way.name);
    select_only(window.selection(), {});
    way.take(window);
    REQUIRE(window.selection().shapes.size() == 1);
    const ShapeId shape = window.selection().shapes[0];
    CHECK(studio.ui.shape == shape);
    window.run("show-cloud");
    const auto in_cloud = shape_in_cloud(*studio.cloud.content, shape);
    if (in_cloud) CHECK(studio.cloud.marked_shapes == std::vector{*in_cloud});
    window.run("show-inspect");
    CHECK(studio.inspection.main.shape->record.id == shape);
    window.run("show-shape");
    CHECK(studio.shape.record->id == shape);
  }
  for (const char* view : {"show-shape", "show-clusters", "show-inspect", "show-cloud", "show-map",
                           "show-plots"})  // at least in the grid beside it
    check_seen_in(window, view, [&] { select_only(window.selection(), {}); });
}

TEST_CASE("A bar of a plot selects its shapes and its part; Ctrl adds them") {
  ExplorerWindow window;
  window.run("show-plot", {"members"});
  const Figure& members = *window.studio().ui.plots.figure;
  const auto clickable = [&](std::size_t point) {
    return !members.panels[0].series[0].shapes[point].empty();
  };
  const std::vector<std::vector<ShapeId>> shapes = members.panels[0].series[0].shapes;
  REQUIRE(shapes.size() == 2);
  const std::size_t first = clickable(0) ? 0 : 1;
  window.click("bar:0:0:" + std::to_string(first));
  std::vector<ShapeId> expected = shapes[first];
  std::ranges::sort(expected);
  CHECK(window.selection().shapes == expected);
  // All of that bar is marked, and what is let go is not.
  const Picture marked = window.picture();
  select_only(window.selection(), {});
  CHECK_FALSE(window.picture() == marked);
  if (clickable(1 - first)) {
    select_only(window.selection(), expected);
    ImGui::GetIO().KeyCtrl = true;
    window.click("bar:0:0:" + std::to_string(1 - first));
    ImGui::GetIO().KeyCtrl = false;
    window.frames(2);
    CHECK(window.selection().shapes.size() == shapes[0].size() + shapes[1].size());
  }
  window.run("show-plot", {"part-presence"});
  window.click("bar:0:0:1");
  REQUIRE(window.selection().part);
  CHECK(window.selection().part->part == 1);
  CHECK(window.selection().shapes.size() ==
        window.studio().ui.plots.figure->panels[0].series[0].shapes[1].size());
}

TEST_CASE("A part that is picked in any view is the picked one in all of them") {
  ExplorerWindow window;
  Studio& studio = window.studio();
  const auto members_of = [&](std::size_t i) { return window.row(i).fit->part_template; };
  const std::string first = std::to_string(members_of(0));
  const std::vector<Way> ways{
      {"editor",
       [](ExplorerWindow& w) {
         w.run("show-shape");
         w.click("part:seat");
         w.run("show-clusters");
       }},
      {"clusters",
       [&](ExplorerWindow& w) {
         w.run("show-clusters");
         w.click("cluster-part:" + first + ":seat");
       }},
      {"inspect",
       [](ExplorerWindow& w) {
         w.run("show-inspect");
         w.click("inspect:part:seat");
       }},
      {"plots",
       [](ExplorerWindow& w) {
         w.run("show-plot", {"part-presence"});
         w.click("bar:0:0:0");
       }},
      {"map",
       [](ExplorerWindow& w) {
         w.run("show-map");
         w.run("wish", {"seat", "width", "1"});
       }},
      {"cloud", [](ExplorerWindow& w) { w.click_cloud_point(); }},
  };
  for (const Way& way : ways) {
    CAPTURE(way.name);
    window.selection().part.reset();
    window.selection().place.reset();
    select_only(studio.ui, std::nullopt);
    window.rest();
    way.take(window);
    window.rest();
    REQUIRE(window.selection().part);
    const std::shared_ptr<const FitTable> table = use_fit_table(studio);
    const auto record =
        std::ranges::find(table->templates, window.selection().part->part_template, &TemplateRecord::id);
    REQUIRE(record != table->templates.end());
    const std::string name = record->part_template.parts[window.selection().part->part].name;
    REQUIRE(studio.ui.part);
    CHECK(studio.history.current().active_template()->parts[*studio.ui.part].name == name);
    window.run("show-inspect");
    const FitLook& look = *studio.inspection.main.look;
    const auto inspected = inspected_part(studio, look);
    if (const auto has = std::ranges::find(look.part_template->parts, name, &TemplatePart::name);
        has != look.part_template->parts.end()) {
      REQUIRE(inspected);
      CHECK(look.part_template->parts[*inspected].name == name);
    }
    window.run("show-plot", {"part-parameters"});
    CHECK(studio.ui.plots.figure->title.ends_with(name));
    window.run("show-clusters");
    CHECK(shown_thumbnail(studio, window.row(0)).highlighted >= 0);
    window.run("show-shape");
    REQUIRE(studio.ui.part);
    CHECK(studio.history.current().active_template()->parts[*studio.ui.part].name == name);
    // There too it is seen, on the shape in view and on all others, until another box is selected; but boxes
    // are edited with all labels seen.
    const bool explored = way.name != "editor";
    CHECK((shown_thumbnail(studio, window.row(0)).highlighted >= 0) == explored);
    REQUIRE(studio.viewport.coloured_part.has_value() == explored);
    const ViewFit& fit = *studio.shape.fit;
    const auto seen = std::ranges::find(fit.part_template->parts, name, &TemplatePart::name);
    if (explored && seen != fit.part_template->parts.end())
      CHECK(*studio.viewport.coloured_part == seen - fit.part_template->parts.begin());
    select_only(studio.ui, *studio.ui.part == 0 ? 1 : 0);
    window.rest();
    CHECK_FALSE(studio.viewport.coloured_part);
    CHECK(shown_thumbnail(studio, window.row(0)).highlighted == -1);
  }
  for (const char* view : {"show-clusters", "show-inspect", "show-cloud", "show-map"})
    check_seen_in(window, view, [&] {
      window.selection().part.reset();
      window.selection().place.reset();
    });
  // What is let go in the editor is let go everywhere.
  window.run("show-shape");
  window.key("Escape");
  CHECK_FALSE(studio.ui.part);
  window.run("show-clusters");
  CHECK_FALSE(window.selection().part);
}

TEST_CASE("A place that is picked on one shape is marked on all of them") {
  ExplorerWindow window;
  Studio& studio = window.studio();
  const std::vector<Way> ways{
      {"cloud", [](ExplorerWindow& w) { w.click_cloud_point(); }},
      {"inspect", [](ExplorerWindow& w) {
         w.run("show-inspect");
         const Target pane = w.target("inspect:shape");
         // Somewhere along the middle there is the shape.
         for (float y = 0.3F; y < 0.8F && !w.selection().place; y += 0.05F)
           w.click_at({(pane.low_x + pane.high_x) / 2, pane.low_y + y * (pane.high_y - pane.low_y)});
       }}};
  for (const Way& way : ways) {
    CAPTURE(way.name);
    window.selection().place.reset();
    way.take(window);
    REQUIRE(window.selection().place);
    CHECK(window.selection().place->on == window.selection().part);
    for (const char* view : {"show-shape", "show-clusters", "show-map", "show-inspect"})
      check_seen_in(window, view, [&] { window.selection().place.reset(); });
    window.run("show-clusters");
    const auto marked = std::ranges::count_if(studio.collection.rows(), [&](const ShapeRow& row) {
      return shown_thumbnail(studio, row).place.has_value();
    });
    CHECK(marked > 1);
    const std::optional<PickedPlace> picked = window.selection().place;
    window.key("Escape");  // first the place, then the part
    CHECK_FALSE(window.selection().place);
    CHECK(window.selection().part);
    window.selection().place = picked;
    window.run("show-shape");
    CHECK(picked_in_viewport(studio));
    window.key("Escape");  // while boxes are edited both go
    CHECK_FALSE(picked_in_viewport(studio));
    CHECK_FALSE(studio.ui.part);
  }
}
