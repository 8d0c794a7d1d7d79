// Every view of the explorer on a project of no, one, some and ten thousand shapes: drawn, and all in it that
// can be clicked is clicked.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "tests/ui/sized_project.h"
#include "tests/ui/test_window.h"
#include "ui/clusters_view.h"
#include "ui/project_actions.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

constexpr std::size_t outlier_every = 10;  // of the made projects, the sixth of each ten

struct SizedWindow : TestWindow {
  explicit SizedWindow(std::size_t shapes) : TestWindow(800, 560), count(shapes) {
    studio().settings.show_bottom = false;
    open_project(studio(), test::make_sized_project(scratch().path(), shapes));
    settle();
  }
  std::size_t outliers() const { return (count + outlier_every - 6) / outlier_every; }
  std::size_t seen(const std::string& prefix) {
    return static_cast<std::size_t>(std::ranges::count_if(
        studio().targets, [&](const Target& target) { return target.name.starts_with(prefix); }));
  }
  std::size_t count;
};

// What each view has to show of that many shapes.
void check_shape(SizedWindow& window) {
  CHECK(window.studio().shape.record.has_value() == (window.count > 0));
  CHECK(window.has("viewport"));
}

void check_clusters(SizedWindow& window) {
  const std::vector<ShapeCluster>& clusters = window.studio().ui.clusters.clusters;
  const auto of_kind = [&](ClusterKind kind) {
    std::size_t shapes = 0;
    for (const ShapeCluster& cluster : clusters)
      if (cluster.kind == kind) shapes += cluster.shown.size();
    return shapes;
  };
  CHECK(of_kind(ClusterKind::outliers) == window.outliers());
  CHECK(of_kind(ClusterKind::members) == window.count - window.outliers());
  const std::size_t cells = window.seen("cluster-cell:");
  CHECK((cells > 0) == (window.count > 0));
  CHECK(cells < 300);  // only those in sight are drawn
  if (window.count < 1000) return;
  ClustersState& state = window.studio().ui.clusters;
  REQUIRE(run_command(window.studio(), "expand-clusters"));
  window.frames(3);
  REQUIRE(state.most_scroll > 10'000);
  state.wanted_scroll = state.most_scroll;
  window.frames(3);
  CHECK(window.seen("cluster-cell:") > 0);
  CHECK(window.seen("cluster-cell:") < 300);
  REQUIRE(run_command(window.studio(), "expand-clusters"));
}

void check_inspect(SizedWindow& window) {
  const Inspection& inspection = window.studio().inspection;
  CHECK(window.has("inspect:shape") == (window.count > 0));
  if (window.count == 0) return;
  REQUIRE(inspection.main.look);
  REQUIRE(inspection.cluster);
  std::size_t members = 0;
  for (const ShapeRow& row : window.studio().collection.rows())
    members += row.fit->part_template == inspection.cluster->of.part_template;
  // Of large clusters some stand for all.
  CHECK(inspection.cluster->terms.shapes <= members);
  CHECK(inspection.cluster->terms.shapes + window.outliers() >= std::min<std::size_t>(members, 1000));
}

void check_cloud(SizedWindow& window) {
  const CloudView& view = window.studio().cloud;
  CHECK(window.has("cloud") == (window.count > 0));
  if (window.count == 0) return;
  REQUIRE(view.content);
  CHECK(view.content->shapes.size() == window.count - window.outliers());
  CHECK(view.asked.outliers == window.outliers());
}

void check_map(SizedWindow& window) {
  CHECK(window.has("map") == (window.count > 0));
  if (window.count > 0) CHECK(window.studio().shape_map.newest->map.points.size() == window.count);
}

void check_plots(SizedWindow& window) {
  for (const PlotEntry& entry : plot_catalog()) CHECK(window.has(std::string("plot:") + entry.name));
  CHECK(window.has("plot") == (window.count > 0));
  if (window.count == 0) return;
  double shapes = 0;
  for (const PlotSeries& series : window.studio().ui.plots.figure->panels[0].series)
    shapes += std::accumulate(series.y.begin(), series.y.end(), 0.0);
  CHECK(shapes == static_cast<double>(window.count));
}

struct View {
  std::string command;
  CentreView view;
  void (*check)(SizedWindow&);
};
const std::array views{View{"show-shape", CentreView::shape, check_shape},
                       View{"show-clusters", CentreView::clusters, check_clusters},
                       View{"show-inspect", CentreView::inspect, check_inspect},
                       View{"show-cloud", CentreView::cloud, check_cloud},
                       View{"show-map", CentreView::map, check_map},
                       View{"show-plots", CentreView::plots, check_plots}};

// Of many alike some are enough, and of those whose handling does not depend on the size one.
bool clicked_enough(std::map<std::string, int>& clicks, const std::string& target, bool large) {
  const int most = large ? 1 : 2;
  const std::string kind = target.substr(0, target.find(':'));
  const bool one_of_many =
      std::set<std::string>{"cell",         "cluster-cell", "map",         "near",    "make-template",
                            "cluster-part", "wish",         "alternative", "splitter"}
          .contains(kind);
  const bool plain = large && kind != "command" && kind != "plot";
  return (one_of_many || plain) && ++clicks[kind] > most;
}

// Jobs over all shapes have tests of their own, and the other views their turn.
bool left_alone(const std::string& target) {
  static const std::set<std::string> names{"command:fit-all",
                                           "command:learn",
                                           "command:measure-sizes",
                                           "command:measure-starts",
                                           "command:learn-automatically",
                                           "command:suggest",
                                           "command:suggest-templates",
                                           "plots:known-folder"};
  return names.contains(target) || target.starts_with("command:show-") || target.starts_with("menu:");
}

// In the middle and its tools; of the explorer's views also at the right. What is around them, and the
// editor, have tests of their own.
bool in_view(TestWindow& window, const View& view, const Target& target) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float x = (target.low_x + target.high_x) / 2;
  const float y = (target.low_y + target.high_y) / 2;
  float left = 0;
  float right = size.x;
  for (const Target& each : window.studio().targets) {
    if (each.name == "splitter:left") left = each.high_x;
    if (each.name == "splitter:right" && view.view != CentreView::inspect) right = each.low_x;
  }
  const float menu_bar = 30;
  return x > left && x < right && y > menu_bar && y < size.y;
}

// What comes up by a click is clicked too. How many clicks that were.
std::size_t click_all(SizedWindow& window, const View& view) {
  std::set<std::string> done;
  std::map<std::string, int> clicks;
  for (;;) {
    const auto next = std::ranges::find_if(window.studio().targets, [&](const Target& target) {
      return in_view(window, view, target) && !left_alone(target.name) && !done.contains(target.name);
    });
    if (next == window.studio().targets.end()) return done.size();
    const std::string name = next->name;
    done.insert(name);
    if (clicked_enough(clicks, name, window.count > 1000)) continue;
    CAPTURE(name);
    window.click(name);
    window.key("Escape");
    if (window.studio().ui.centre == view.view) continue;
    REQUIRE(run_command(window.studio(), view.command));
    window.frames(2);
  }
}

void check_no_errors(SizedWindow& window) {
  for (const Message& message : window.studio().messages.list()) {
    CAPTURE(message.text);
    CHECK(message.severity != Severity::error);
  }
}

void check_all_views(std::size_t count) {
  SizedWindow window(count);
  REQUIRE(window.studio().collection.rows().size() == count);
  for (const View& view : views) {
    CAPTURE(view.command);
    REQUIRE(run_command(window.studio(), view.command));
    window.settle();
    view.check(window);
    CHECK(click_all(window, view) > 1);
    while (window.studio().history.can_undo()) window.studio().history.undo();
    window.settle();
    check_no_errors(window);
    CHECK(window.studio().collection.rows().size() == count);
  }
}

}  // namespace

TEST_CASE("Every view of an empty project is drawn, and all in it is clicked") {
  check_all_views(0);
}

TEST_CASE("Every view of a project of one shape is drawn, and all in it is clicked") {
  check_all_views(1);
}

TEST_CASE("Every view of a project of 36 shapes is drawn, and all in it is clicked") {
  check_all_views(36);
}

TEST_CASE("Every view of a project of ten thousand shapes is drawn, and all in it is clicked") {
  check_all_views(10'000);
}
