// The clusters and the filter, really clicked; one selection over all panels.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/session/actions.h"
#include "tests/ui/test_window.h"
#include "ui/clusters_view.h"
#include "ui/picture_marks.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

void run(TestWindow& window, const char* command, const std::vector<std::string>& arguments = {}) {
  CAPTURE(command);
  REQUIRE(run_command(window.studio(), command, arguments));
  window.settle();
}

// Chairs, fitted, with the clusters in the middle.
void open_fitted(TestWindow& window, std::size_t count) {
  window.open_chairs(count);
  window.make_template();
  run(window, "fit-all");
  run(window, "show-clusters");
  run(window, "expand-clusters");
}

std::size_t cells(TestWindow& window) {
  return static_cast<std::size_t>(std::ranges::count_if(window.studio().targets, [](const Target& target) {
    return target.name.starts_with("cluster-cell:");
  }));
}

const ShapeRow& row(TestWindow& window, std::size_t i) {
  return window.studio().collection.rows()[i];
}

std::string cell(TestWindow& window, std::size_t i) {
  return "cluster-cell:" + row(window, i).name;
}

TemplateId id_of_template(TestWindow& window) {
  return row(window, 0).fit->part_template;
}

void with_key(TestWindow& window, bool ImGuiIO::*key, const std::string& target) {
  ImGui::GetIO().*key = true;
  window.click(target);
  ImGui::GetIO().*key = false;
  window.frames(2);
}

}  // namespace

TEST_CASE("Without shapes, or without fits, the clusters say what to do next") {
  TestWindow window;
  run(window, "show-clusters");
  CHECK(cells(window) == 0);
  window.open_chairs(1);
  CHECK(window.has("command:learn-automatically"));
  window.make_template();
  CHECK(window.has("command:learn"));
}

TEST_CASE("One shape that is fitted stands beside its template") {
  TestWindow window;
  open_fitted(window, 1);
  CHECK(cells(window) == 1);
  CHECK(window.has("cluster-picture:" + std::to_string(id_of_template(window))));
  window.click(cell(window, 0));
  CHECK(window.studio().ui.selection.shapes == std::vector{row(window, 0).id});
}

TEST_CASE("A click selects and shows, Ctrl and Shift extend, and all panels have the same selection") {
  TestWindow window;
  open_fitted(window, 6);
  ExplorerSelection& selection = window.studio().ui.selection;
  window.click(cell(window, 1));
  CHECK(selection.shapes == std::vector{row(window, 1).id});
  CHECK(window.studio().ui.shape == row(window, 1).id);
  with_key(window, &ImGuiIO::KeyCtrl, cell(window, 3));
  CHECK(selection.shapes.size() == 2);
  CHECK(window.studio().ui.shape == row(window, 1).id);  // what is shown stays
  with_key(window, &ImGuiIO::KeyCtrl, cell(window, 3));
  CHECK(selection.shapes.size() == 1);
  with_key(window, &ImGuiIO::KeyShift, cell(window, 4));
  CHECK(selection.shapes.size() == 4);
  // The grid on the left sets the same one.
  window.click("cell:" + row(window, 0).name);
  CHECK(selection.shapes == std::vector{row(window, 0).id});
  // What is under the mouse here is seen there.
  window.press_on(cell(window, 1));
  CHECK(selection.hovered == row(window, 1).id);
  window.let_go();
  window.key("Escape");
  CHECK(selection.shapes.empty());
}

TEST_CASE("Arrow keys go through the members as they stand, and Shift takes them along") {
  TestWindow window;
  open_fitted(window, 8);
  window.click(cell(window, 0));
  const ClusterLayout& layout = window.studio().ui.clusters.layout;
  REQUIRE(layout.columns >= 2);
  REQUIRE(layout.columns < 8);
  window.key("Right");
  CHECK(window.studio().ui.shape == row(window, 1).id);
  window.key("Left");
  window.key("Left");
  CHECK(window.studio().ui.shape == row(window, 0).id);
  window.key("Down");
  CHECK(window.studio().ui.shape == row(window, layout.columns).id);
  window.key("Up");
  CHECK(window.studio().ui.shape == row(window, 0).id);
  window.key("Shift+Right");
  CHECK(window.studio().ui.selection.shapes.size() == 2);
}

TEST_CASE("A double click opens the shape by itself with the template that explains it") {
  TestWindow window;
  open_fitted(window, 3);
  window.double_click(cell(window, 2));
  CHECK(window.studio().ui.centre == CentreView::shape);
  CHECK(window.studio().ui.shape == row(window, 2).id);
  CHECK_FALSE(window.studio().ui.look);  // it is the active one
  // Edited meanwhile, the one of the cluster is looked at, and the document stays.
  run(window, "select-part", {"seat"});
  run(window, "set-size", {"0.5", "0.1", "0.5"});
  const Document edited = window.studio().history.committed();
  run(window, "show-clusters");
  run(window, "open-shape", {row(window, 1).name});
  REQUIRE(window.studio().ui.look);
  CHECK(window.studio().history.committed() == edited);
}

TEST_CASE("A part that is clicked in the legend or the picture is highlighted on all shapes") {
  TestWindow window;
  open_fitted(window, 3);
  ExplorerSelection& selection = window.studio().ui.selection;
  const std::string id = std::to_string(id_of_template(window));
  const WantedThumbnail plain = shown_thumbnail(window.studio(), row(window, 0));
  CHECK(plain.highlighted == -1);
  window.click("cluster-part:" + id + ":back");
  window.settle();
  REQUIRE(selection.part);
  CHECK(selection.part->part == 1);
  const WantedThumbnail dimmed = shown_thumbnail(window.studio(), row(window, 0));
  CHECK(dimmed.highlighted == 1);
  CHECK(window.studio().thumbnails.use(dimmed) != 0);
  window.click("cluster-part:" + id + ":back");
  CHECK_FALSE(selection.part);
  // In the middle of the picture there is always some part of a chair.
  window.click("cluster-picture:" + id);
  CHECK(selection.part);
  window.key("Escape");
  CHECK_FALSE(selection.part);
  run(window, "highlight-part", {"seat"});
  REQUIRE(selection.part);
  CHECK(selection.part->part == 0);
  CHECK_FALSE(run_command(window.studio(), "highlight-part", std::vector<std::string>{"no such part"}));
}

TEST_CASE("Dimming keeps the pixels of the part, and takes colour and strength from all others") {
  Picture picture{3, 1, {200, 0, 0, 255, 0, 200, 0, 255, 0, 0, 0, 0}};
  const Picture mask{3, 1, {1, 0, 0, 255, 44, 1, 0, 255, 0, 0, 0, 0}};  // part 0, part 299, backdrop
  Picture first = picture;
  highlight_part(first, mask, 0);
  CHECK(std::equal(first.pixels.begin(), first.pixels.begin() + 4, picture.pixels.begin()));
  CHECK(first.pixels[7] < 128);
  CHECK(first.pixels[4] > 60);  // greyer
  Picture other = picture;
  highlight_part(other, mask, 299);
  CHECK(other.pixels[3] < 128);
  CHECK(std::equal(other.pixels.begin() + 4, other.pixels.begin() + 8, picture.pixels.begin() + 4));
  highlight_part(picture, mask, no_such_part);
  CHECK(picture.pixels[3] < 128);
  CHECK(picture.pixels[7] < 128);
}

TEST_CASE("Outliers stand apart, and a template is made from one: one step that is undone and redone") {
  TestWindow window;
  open_fitted(window, 4);
  Project project = Project::open(window.studio().collection.path);
  project.set_fit_status(row(window, 2).id, FitStatus::outlier);
  // Read anew, as after a job.
  run(window, "open-project", {window.studio().collection.path.string()});
  run(window, "show-clusters");
  const auto& clusters = follow_clusters(window.studio());
  REQUIRE(clusters.size() == 2);
  CHECK(clusters[1].kind == ClusterKind::outliers);
  CHECK(clusters[1].shown == std::vector<std::size_t>{2});
  const Document before = window.studio().history.committed();
  window.press_on(cell(window, 2));  // the button comes with the mouse
  window.let_go();
  REQUIRE(window.has("make-template:" + row(window, 2).name));
  window.click("make-template:" + row(window, 2).name);
  window.settle();
  const Document after = window.studio().history.committed();
  REQUIRE(after.templates.size() == before.templates.size() + 1);
  CHECK(after.active_template()->name == "from " + row(window, 2).name);
  CHECK(after.active_template()->parts.size() >= 2);
  CHECK(window.studio().ui.centre == CentreView::shape);
  window.key("Ctrl+Z");
  CHECK(window.studio().history.committed() == before);
  window.key("Ctrl+Shift+Z");
  CHECK(window.studio().history.committed() == after);
}

TEST_CASE(
    "One filter drives the grid and the clusters; brushed in a histogram and cleared by a double click") {
  TestWindow window(1280, 900);
  open_fitted(window, 12);
  run(window, "show-filter");
  window.settle();
  REQUIRE(window.has("histogram:0"));
  const auto shown = [&] { return shown_rows(window.studio()).size(); };
  CHECK(shown() == 12);
  // From the middle of the energies to the right end.
  window.drag("histogram:0", 200, 0);
  window.settle();
  const std::size_t worse = shown();
  CHECK(worse > 0);
  CHECK(worse < 12);
  CHECK(cells(window) == worse);
  REQUIRE(window.studio().ui.shown.filter.ranges.size() == 1);
  CHECK(std::isinf(window.studio().ui.shown.filter.ranges[0].high));
  window.double_click("histogram:0");
  window.settle();
  CHECK(shown() == 12);
  const std::string chip = "filter-template:" + std::to_string(id_of_template(window));
  window.click(chip);
  CHECK(shown() == 0);
  CHECK(window.has("command:clear-filter"));
  window.click(chip);
  CHECK(shown() == 12);
  window.click("filter-part-add");
  window.click("filter-add:back");
  const std::size_t with_back = shown();
  window.key("Escape");
  window.frames(2);
  window.click("filter-part:back");
  CHECK(shown() == 12 - with_back);
  run(window, "clear-filter");
  CHECK(shown() == 12);
}

TEST_CASE("Shapes are sorted by the menu, and by commands of scripts") {
  TestWindow window;
  open_fitted(window, 6);
  window.click("grid:order");
  window.click("column:energy");
  const auto energies_rise = [&] {
    const auto& rows = shown_rows(window.studio());
    return std::ranges::is_sorted(rows, {},
                                  [&](std::size_t i) { return row(window, i).fit->energy.total(); });
  };
  CHECK(energies_rise());
  CHECK(window.studio().ui.shown.order.column.quantity == ShapeQuantity::energy);
  run(window, "sort-by", {"part-half-y", "up", "seat"});
  CHECK(window.studio().ui.shown.order == ShapeOrder{{ShapeQuantity::part_half_y, "seat"}, false});
  window.click(cell(window, 3));
  run(window, "sort-similar");
  CHECK(shown_rows(window.studio()).front() == 3);
  CHECK_FALSE(run_command(window.studio(), "sort-by", std::vector<std::string>{"beauty"}));
  run(window, "filter-range", {"energy", "*", "0"});
  CHECK(shown_rows(window.studio()).empty());
  run(window, "clear-filter");
  CHECK(shown_rows(window.studio()).size() == 6);
}

TEST_CASE("The menu of a shape does what it says with that shape") {
  TestWindow window;
  open_fitted(window, 4);
  Studio& studio = window.studio();
  const auto choose = [&](std::size_t i, const std::string& entry) {
    CAPTURE(entry);
    run(window, "show-clusters");
    window.press_on(cell(window, i));
    window.let_go();
    ImGui::GetIO().MouseDown[1] = true;
    window.frames();
    ImGui::GetIO().MouseDown[1] = false;
    window.frames(3);
    REQUIRE(window.has("shape-menu:" + entry));
    window.click("shape-menu:" + entry);
    window.settle();
  };
  choose(1, "similar");
  CHECK(studio.ui.shown.order.column.quantity == ShapeQuantity::similarity);
  CHECK(studio.ui.shown.order.column.shape == row(window, 1).id);
  run(window, "sort-by", {"name"});
  choose(2, "cluster");
  CHECK(studio.ui.selection.shapes.size() == 4);
  choose(3, "mark-outlier");
  CHECK(row(window, 3).fit->status == FitStatus::outlier);
  choose(3, "learn-from-shape");
  CHECK(row(window, 3).fit->status == FitStatus::learned);
  choose(2, "strip-add");
  CHECK(std::ranges::count(studio.ui.strip.shapes, row(window, 2).id) == 1);
  choose(0, "show-inspect");
  CHECK(studio.ui.centre == CentreView::inspect);
  CHECK(studio.ui.shape == row(window, 0).id);
  choose(2, "open");
  CHECK(studio.ui.centre == CentreView::shape);
  CHECK(studio.ui.shape == row(window, 2).id);
  const std::size_t templates = studio.history.committed().templates.size();
  choose(1, "template-from-shape");
  CHECK(studio.history.committed().templates.size() == templates + 1);
}
