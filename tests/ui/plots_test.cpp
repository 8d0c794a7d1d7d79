// The view of plots: chosen, hovered, saved, compared with ground truth; on no, few and very many shapes.
#include <doctest/doctest.h>

#include <algorithm>

#include "core/io/file.h"
#include "core/report/plot_catalog.h"
#include "tests/report/made_reports.h"
#include "tests/ui/made_learning.h"
#include "tests/ui/made_project.h"
#include "tests/ui/test_window.h"
#include "ui/plot_sources.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

// Every plot is chosen by a click, drawn, and hovered all over.
void look_at_all(TestWindow& window) {
  REQUIRE(run_command(window.studio(), "show-plots"));
  window.settle();
  for (const PlotEntry& entry : plot_catalog()) {
    CAPTURE(std::string(entry.name));
    if (!window.has(std::string("plot:") + entry.name)) continue;  // below the edge of a small window
    window.click(std::string("plot:") + entry.name);
    window.settle();
    CHECK(window.studio().ui.plots.chosen == entry.name);
    CHECK(window.has("plot") == (window.studio().ui.plots.figure != nullptr));
    if (!window.has("plot")) continue;
    window.press_on("plot");
    window.let_go();
    for (int i = 0; i < 6; ++i) window.move_by(17, 11);
  }
}

}  // namespace

TEST_CASE("Plots of nothing, of one shape, of some and of ten thousand are drawn and can be hovered") {
  for (const std::size_t count : {0u, 1u, 36u, 10'000u}) {
    CAPTURE(count);
    TestWindow window;
    if (count > 0) test::open_made(window, count);
    if (count == 36)
      window.studio().collection.content.learning =
          std::make_shared<const LearningRecord>(test::made_learning(8, 4, 36));
    look_at_all(window);
    REQUIRE(run_command(window.studio(), "show-plot", std::vector<std::string>{"members"}));
    window.settle();
    CHECK((window.studio().ui.plots.figure != nullptr) == (count > 0));
  }
}

TEST_CASE("A plot is saved as SVG and as CSV, by the commands of its buttons") {
  TestWindow window;
  test::open_made(window, 36);
  REQUIRE(run_command(window.studio(), "show-plot", std::vector<std::string>{"part-parameters"}));
  window.settle();
  for (const char* ending : {"svg", "csv"}) {
    const std::string command = std::string("save-plot-") + ending;
    window.click("command:" + command);
    CHECK(window.studio().ui.browser.open);
    CHECK(window.studio().ui.browser.typed == std::string("part-parameters.") + ending);
    window.click("browser:cancel");
    const std::string path = (window.scratch().path() / "figure").string();
    REQUIRE(run_command(window.studio(), command, std::vector<std::string>{path}));
    CHECK(read_file(path + "." + ending).size() > 1000);
  }
  CHECK_FALSE(run_command(window.studio(), "save-plot-svg", std::vector<std::string>{"/none/figure.svg"}));
  CHECK_FALSE(run_command(window.studio(), "show-plot", std::vector<std::string>{"nothing"}));
}

TEST_CASE("A part chosen for a plot is the part that all panels have chosen, and the other way round") {
  TestWindow window;
  test::open_made(window, 36);
  REQUIRE(run_command(window.studio(), "show-plot", std::vector<std::string>{"part-parameters"}));
  window.settle();
  window.click("focus:part");
  window.click("focus:part:1");
  REQUIRE(window.studio().ui.selection.part);
  CHECK(window.studio().ui.selection.part->part == 1);
  window.settle();
  CHECK(window.studio().ui.plots.figure->title.find("back") != std::string::npos);
  window.studio().ui.selection.part->part = 0;
  window.settle();
  CHECK(window.studio().ui.plots.figure->title.find("seat") != std::string::npos);
}

TEST_CASE("True labels and landmarks beside the shapes are offered, compared with, and remembered") {
  TestWindow window;
  window.open_chairs(3);
  window.make_template();
  REQUIRE(run_command(window.studio(), "show-plot", std::vector<std::string>{"accuracy-by-label"}));
  window.settle();
  CHECK_FALSE(window.studio().ui.plots.figure);
  REQUIRE(window.has("command:evaluate-labels"));
  CHECK_FALSE(run_command(window.studio(), "evaluate-labels"));  // nothing is fitted
  REQUIRE(run_command(window.studio(), "fit-all"));
  window.settle();
  REQUIRE(window.has("plots:known-folder"));
  window.click("plots:known-folder");
  window.settle();
  REQUIRE(window.studio().ui.plots.figure);
  CHECK(window.studio().ui.plots.evaluations.labelling->report.shapes.size() == 3);
  CHECK_FALSE(evaluated_before(window.studio()));

  REQUIRE(run_command(window.studio(), "show-plot", std::vector<std::string>{"correspondence"}));
  const std::string folder = (window.scratch().path() / "chairs" / "landmarks").string();
  REQUIRE(run_command(window.studio(), "evaluate-landmarks", std::vector<std::string>{folder}));
  window.settle();
  REQUIRE(window.studio().ui.plots.figure);
  CHECK(window.studio().collection.content.truth.landmarks == folder);

  // A folder without any truth is an error that says so, and leaves what was there.
  const std::vector<std::string> none{window.scratch().path().string()};
  REQUIRE(run_command(window.studio(), "evaluate-labels", none));
  window.settle();
  CHECK(window.studio().jobs.view().at(0).state == JobState::failed);
  CHECK(window.studio().ui.plots.evaluations.labelling);
  CHECK_FALSE(run_command(window.studio(), "evaluate-labels", std::vector<std::string>{"/no/such/folder"}));

  // Other fits: what was compared is of before.
  window.click("part:seat");
  window.drag("field:Centre.y", 60, 0, 4);
  REQUIRE(run_command(window.studio(), "fit-all"));
  window.settle();
  CHECK(evaluated_before(window.studio()));
}
