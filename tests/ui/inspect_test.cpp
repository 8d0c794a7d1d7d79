// A single fit is looked into, and what a person corrects of it holds from the next fit on.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>

#include "core/session/correction_actions.h"
#include "tests/ui/test_window.h"
#include "ui/inspect_actions.h"
#include "ui/inspect_brush.h"
#include "ui/inspection.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

// Some chairs, fitted, and the first one inspected.
void open_fitted(TestWindow& window, std::size_t count) {
  window.open_chairs(count);
  window.make_template();
  REQUIRE(run_command(window.studio(), "fit-all"));
  window.settle();
  REQUIRE(run_command(window.studio(), "show-inspect"));
  window.settle();
  REQUIRE(window.studio().inspection.main.look);
}

const ShapeFit& shown(TestWindow& window) {
  return window.studio().inspection.main.look->fit;
}

FitSummary stored(TestWindow& window) {
  const Studio& studio = window.studio();
  return studio.collection.rows()[*find_row(studio.collection, *studio.ui.shape)].fit.value();
}

bool run(TestWindow& window, const char* command, const std::vector<std::string>& arguments = {}) {
  const bool done = run_command(window.studio(), command, arguments);
  window.settle();
  return done;
}

}  // namespace

TEST_CASE("The view of a single fit says what to do while there is nothing to inspect") {
  TestWindow window;
  REQUIRE(run_command(window.studio(), "show-inspect"));
  window.frames(3);
  CHECK_FALSE(window.has("inspect:shape"));
  window.open_chairs(1);
  window.settle();
  CHECK(window.has("inspect:shape"));  // as it stands: it was not fitted yet
  CHECK_FALSE(window.studio().inspection.main.look);
  window.click("command:show-shape");
  CHECK(window.has("viewport"));
  window.click("command:show-inspect");
  window.settle();
  CHECK(window.has("inspect:shape"));
}

TEST_CASE("What other yaws score is seen by a click, can be pinned, and the next fit and learning heed it") {
  TestWindow window;
  open_fitted(window, 2);
  Studio& studio = window.studio();
  const Alternatives* all = alternatives_of_view(studio);
  REQUIRE(all);
  CHECK(all->fits.size() == 4);
  const int before = stored(window).yaw_quarters;
  CHECK(shown(window).yaw_quarters == before);
  const int other = (before + 1) % 4;
  window.click("alternative:chair:" + std::to_string(other * 90));
  window.settle();
  CHECK(shown(window).yaw_quarters == other);
  CHECK(stored(window).yaw_quarters == before);

  window.click("command:pin-shown");
  window.settle();
  CHECK(correction_in_view(studio).yaw_quarters == other);
  CHECK(shown(window).yaw_quarters == other);
  CHECK(stored(window).yaw_quarters == other);  // it was fitted anew by itself
  CHECK(outdated_fits(studio) == 0);
  window.key("Ctrl+Z");
  window.settle();
  CHECK(shown(window).yaw_quarters == before);
  CHECK(stored(window).yaw_quarters == before);
  CHECK(outdated_fits(studio) == 0);
  window.key("Ctrl+Shift+Z");
  window.settle();
  CHECK(stored(window).yaw_quarters == other);
  CHECK(shown(window).yaw_quarters == other);
  CHECK(outdated_fits(studio) == 0);
  REQUIRE(run(window, "fit-all"));
  CHECK(stored(window).yaw_quarters == other);
  REQUIRE(run(window, "learn"));
  REQUIRE(studio.collection.content.learning);
  CHECK(stored(window).yaw_quarters == other);
  CHECK(correction_in_view(studio).yaw_quarters == other);
}

TEST_CASE("A shape that boxes were drawn on stands right again after its yaw was pinned and set free") {
  TestWindow window;
  open_fitted(window, 2);
  Studio& studio = window.studio();
  studio.ui.points.made_on = studio.shape.shape_revision;
  studio.ui.points.made_for = "chair";
  const int before = studio.shape.fit->fit.yaw_quarters;
  const int other = (before + 2) % 4;
  REQUIRE(run(window, "pin-yaw", {std::to_string(other * 90)}));
  CHECK(studio.shape.fit->fit.yaw_quarters == other);
  window.key("Ctrl+Z");
  window.settle();
  CHECK(studio.shape.fit->fit.yaw_quarters == before);
}

TEST_CASE("A close look at one fit stays close when another shape comes into view") {
  TestWindow window;
  open_fitted(window, 2);
  Camera& camera = window.studio().inspection.camera;
  const ShapeId first = *window.studio().ui.shape;
  const Camera whole = camera;
  camera.distance *= 0.3;
  const Camera close = camera;
  window.settle();
  CHECK(run(window, "next-shape"));
  REQUIRE(window.studio().ui.shape != first);
  CHECK(camera == close);
  CHECK(run(window, "frame"));
  CHECK(camera.distance > 0.6 * whole.distance);
}

TEST_CASE("The alternations are gone through step by step") {
  TestWindow window;
  open_fitted(window, 1);
  const std::vector<ShapeFit>* steps = shown_steps(window.studio());
  REQUIRE(steps);
  REQUIRE(steps->size() > 2);
  CHECK(window.has("inspect:steps"));
  for (const std::size_t step : {std::size_t{0}, std::size_t{1}, steps->size() - 1}) {
    REQUIRE(run(window, "inspect-step", {std::to_string(step)}));
    CHECK(shown(window).alternations == (*steps)[step].alternations);
    CHECK(shown(window).energy == (*steps)[step].energy);
  }
  window.click("inspect:steps");  // in the middle
  window.settle();
  CHECK(shown(window).alternations < steps->back().alternations);
}

TEST_CASE("Pointing at one shape shows the place on the other, and a click picks it for all views") {
  TestWindow window;
  open_fitted(window, 3);
  Studio& studio = window.studio();
  REQUIRE(run(window, "inspect-beside"));
  REQUIRE(studio.inspection.beside.look);
  CHECK(studio.ui.inspect.beside != studio.ui.shape);
  window.press_on("inspect:shape");
  window.let_go();
  window.frames(2);
  REQUIRE(studio.inspection.hovered);
  CHECK(studio.ui.selection.hovered == studio.ui.shape);
  REQUIRE(studio.ui.selection.place);
  CHECK(studio.ui.selection.place->shape == studio.ui.shape);
  CHECK(studio.inspection.hovered->on_other.has_value());
  window.click("command:inspect-alone");
  CHECK_FALSE(studio.ui.inspect.beside);
}

TEST_CASE("A place found on the same shape is where it was pointed at") {
  TestWindow window;
  open_fitted(window, 1);
  const FitLook& look = *window.studio().inspection.main.look;
  for (const std::uint32_t i : {10U, 300U, 700U}) {
    const Vec3 p = look.shape->samples->points[i];
    const auto on_template = place_on_template(look, p);
    if (!on_template) continue;
    const auto back = place_on_shape(look, *look.part_template, *on_template);
    REQUIRE(back);
    CHECK((*back - p).norm() < 0.05);
  }
}

TEST_CASE("A stroke of the brush pins what it touches in one step, and the next fit heeds it") {
  TestWindow window;
  open_fitted(window, 1);
  Studio& studio = window.studio();
  REQUIRE(run(window, "paint-labels", {"leg"}));
  const Document before = studio.history.current();
  const std::size_t steps = studio.history.entries().size();
  window.drag("inspect:shape", 30, 10);
  CHECK(studio.history.entries().size() == steps + 1);
  const ShapeCorrection painted = correction_in_view(studio);
  REQUIRE(painted.pinned.contains("leg"));
  const Document after = studio.history.current();
  window.key("Ctrl+Z");
  CHECK(studio.history.current() == before);
  window.key("Ctrl+Shift+Z");
  CHECK(studio.history.current() == after);
  window.settle();
  const auto all_legs = [&](const ShapeFit& fit) {
    return std::ranges::all_of(painted.pinned.at("leg"), [&](std::uint32_t i) { return fit.labels[i] == 2; });
  };
  CHECK(all_legs(shown(window)));
  CHECK(all_legs(studio.inspection.main.shape->fit->fit));

  // Esc drops a stroke that is under way.
  window.press_on("inspect:shape");
  window.move_by(40, 30);
  window.key("Escape");
  window.move_by(10, 10);
  window.let_go();
  CHECK_FALSE(studio.history.has_preview());
  CHECK(studio.history.current() == after);
  REQUIRE(run(window, "free-points"));
  CHECK(correction_in_view(studio).empty());
}

TEST_CASE("A quick stroke of the brush has no gaps: it pins what a slow one does") {
  const std::vector<glm::dvec2> way = way_of_brush({100, 50}, {80, 0}, 20);
  REQUIRE(way.size() == 16);
  CHECK(way.back() == glm::dvec2(100, 50));
  for (std::size_t i = 1; i < way.size(); ++i) CHECK(glm::length(way[i] - way[i - 1]) <= 5.001);
  CHECK(way.front().x == doctest::Approx(25));
  CHECK(way_of_brush({5, 5}, {0, 0}, 20).size() == 1);
  CHECK(way_of_brush({5, 5}, {1e6, 0}, 0.01).size() < 100);
  std::vector<std::vector<std::uint32_t>> pinned;
  for (const int steps : {1, 40}) {
    TestWindow window;
    open_fitted(window, 1);
    Studio& studio = window.studio();
    REQUIRE(run(window, "paint-labels", {"leg"}));
    studio.ui.inspect.brush_radius = 0.08;
    window.press_on("inspect:shape");
    window.move_by(0, -60);
    for (int i = 0; i < steps; ++i) window.move_by(0, 120.0F / static_cast<float>(steps));
    window.let_go();
    pinned.push_back(correction_in_view(studio).pinned.at("leg"));
  }
  REQUIRE(pinned[1].size() > 10);
  std::vector<std::uint32_t> both;
  std::ranges::set_intersection(pinned[0], pinned[1], std::back_inserter(both));
  CHECK(both.size() > 0.95 * static_cast<double>(pinned[0].size()));
  CHECK(both.size() > 0.95 * static_cast<double>(pinned[1].size()));
}

TEST_CASE("Marks are switches, and what is selected together is marked together") {
  TestWindow window;
  open_fitted(window, 3);
  Studio& studio = window.studio();
  window.click("command:mark-outlier");
  CHECK(correction_in_view(studio).mark == ShapeMark::outlier);
  window.click("command:mark-outlier");
  CHECK(correction_in_view(studio).mark == ShapeMark::none);
  std::vector<ShapeId> all;
  for (const ShapeRow& row : studio.collection.rows()) all.push_back(row.id);
  select_only(studio.ui.selection, all);
  window.click("command:learn-from-shape");
  REQUIRE(studio.history.current().corrections);
  CHECK(studio.history.current().corrections->size() == 3);
  window.settle();
  for (const ShapeRow& row : studio.collection.rows()) CHECK(row.fit->status == FitStatus::learned);
}

TEST_CASE("Nothing that is clicked in the corrections moves while what was marked is fitted") {
  TestWindow window;
  open_fitted(window, 3);
  const auto place = [&](const std::string& target) {
    const auto& targets = window.studio().targets;
    const auto found = std::ranges::find(targets, target, &Target::name);
    REQUIRE(found != targets.end());
    return std::pair(found->low_y, found->high_y);
  };
  const std::vector<std::string> clicked{"alternative:chair:0", "command:pin-shown", "command:mark-outlier",
                                         "command:learn-from-shape", "command:template-from-shape"};
  std::vector<std::pair<float, float>> before;
  for (const std::string& each : clicked) before.push_back(place(each));
  for (const char* mark : {"mark-outlier", "pin-shown", "mark-outlier"}) {
    REQUIRE(run_command(window.studio(), mark));
    for (int frame = 0; frame < 20; ++frame) {
      window.frames();
      for (std::size_t i = 0; i < clicked.size(); ++i) CHECK(place(clicked[i]) == before[i]);
    }
    window.settle();
    for (std::size_t i = 0; i < clicked.size(); ++i) CHECK(place(clicked[i]) == before[i]);
  }
}

TEST_CASE("What was corrected is there when the project is opened again") {
  TestWindow window;
  open_fitted(window, 2);
  Studio& studio = window.studio();
  pin_yaw(studio.history, shape_in_view(studio), 2);
  mark_shapes(studio.history, shapes_to_correct(studio), ShapeMark::outlier);
  const Document document = studio.history.current();
  save_now(studio);
  CHECK(read_document(Project::open(studio.collection.path)) == document);
}

TEST_CASE("Surface and samples are coloured by each term of the energy, whose name may not be another") {
  TestWindow window;
  open_fitted(window, 1);
  REQUIRE(run(window, "inspect-samples"));
  std::vector<Picture> pictures;
  for (const char* colour : {"plain", "distance", "features", "smoothness", "part"}) {
    CHECK(run(window, "inspect-colour", {colour}));
    pictures.push_back(window.window().picture());
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) CHECK_FALSE(pictures[i] == pictures.back());
  }
  CHECK_FALSE(run(window, "inspect-colour", {"taste"}));
}

TEST_CASE(
    "A click on a term of the energy shows it on the shape, a second one takes it away, in small windows "
    "too") {
  TestWindow window;
  open_fitted(window, 1);
  Studio& studio = window.studio();
  const Picture plain = window.window().picture();
  for (const auto& [term, colour] :
       {std::pair("Shape to template", "distance"), std::pair("Features", "features"),
        std::pair("Smoothness", "smoothness")}) {
    window.click(std::string("inspect:term:") + term);
    CHECK(studio.settings.inspect_colour == colour);
    CHECK_FALSE(window.window().picture() == plain);
    window.click(std::string("inspect:term:") + term);
    CHECK(studio.settings.inspect_colour == "part");
  }
  const bool means = studio.settings.inspect_mean_boxes;
  window.click("inspect:term:Deformation");
  CHECK(studio.settings.inspect_mean_boxes != means);
  window.click("inspect:term:Template to shape");
  CHECK(studio.settings.inspect_template_points);
  window.click("inspect:term:Existence");  // has no picture
  CHECK(studio.settings.inspect_colour == "part");
}
