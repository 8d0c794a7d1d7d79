// Co-aligned clouds in the window: drawn, turned, clicked, on no, one, several and very many shapes.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/session/fit_collection.h"
#include "core/session/import_shapes.h"
#include "tests/support/small_collection.h"
#include "tests/ui/test_window.h"
#include "ui/project_actions.h"

using namespace archetype;
using test::TestWindow;

namespace {

void run(TestWindow& window, const char* command, const std::vector<std::string>& arguments = {}) {
  CAPTURE(command);
  REQUIRE(run_command(window.studio(), command, arguments));
  window.settle();
}

// A project of fitted chairs, in the view of clouds.
void show_fitted_chairs(TestWindow& window, std::size_t count, int points = 200) {
  const auto folder = window.scratch().path();
  test::write_chairs(folder / "made", count);
  {
    Project project = Project::create(folder / "fitted.archetype");
    ImportOptions options;
    options.points = points;
    import_shapes(project, {folder / "made" / "shapes"}, options, {});
    fit_collection(project, {test::chair_template()}, {}, 2, {});
  }
  open_project(window.studio(), folder / "fitted.archetype");
  window.settle();
  run(window, "show-cloud");
}

Target target_of(TestWindow& window, const std::string& name) {
  for (const Target& target : window.studio().targets)
    if (target.name == name) return target;
  FAIL("there is no " << name);
  return {};
}

// Where a point of the cloud is drawn in a pane, on the screen.
ImVec2 place_of(TestWindow& window, std::size_t point, bool deformed) {
  const CloudView& view = window.studio().cloud;
  const Target pane = target_of(window, deformed ? "cloud:deformed" : "cloud");
  const Viewport viewport{static_cast<int>(pane.high_x - pane.low_x),
                          static_cast<int>(pane.high_y - pane.low_y)};
  const PointGeometry& points = *view.content->points;
  const auto at = to_screen(view.camera, viewport, deformed ? points.moved[point] : points.positions[point]);
  REQUIRE(at);
  return {pane.low_x + static_cast<float>(at->x), pane.low_y + static_cast<float>(at->y)};
}

// The point that stands nearest to the eye: nothing hides it.
std::size_t front_point(TestWindow& window, bool deformed) {
  const CloudView& view = window.studio().cloud;
  const auto& points = deformed ? view.content->points->moved : view.content->points->positions;
  const auto depth = [&](const glm::vec3& p) { return view_depth(view.camera, p); };
  return static_cast<std::size_t>(std::ranges::min_element(points, {}, depth) - points.begin());
}

}  // namespace

TEST_CASE("Without shapes or fits the cloud says what to do first") {
  TestWindow window;
  run(window, "show-cloud");
  CHECK_FALSE(window.has("cloud"));
  window.open_chairs(1);
  window.settle();
  CHECK_FALSE(window.has("cloud"));
  CHECK(window.studio().cloud.content == nullptr);
  window.click("command:show-shape");  // the tab
  CHECK(window.studio().ui.centre == CentreView::shape);
}

TEST_CASE("All points of the fitted shapes stand rigid beside deformed, and turn together") {
  TestWindow window;
  show_fitted_chairs(window, 6);
  const CloudView& view = window.studio().cloud;
  REQUIRE(view.content);
  CHECK(view.content->shapes.size() == 6);
  CHECK(view.content->of.size() == view.content->samples);
  CHECK(view.content->sharpness.deformed < view.content->sharpness.rigid);
  CHECK(window.has("cloud"));
  CHECK(window.has("cloud:deformed"));
  CHECK(view.pictures[0].whole);
  CHECK(view.pictures[1].whole);
  const Picture before = window.window().picture();
  const Camera camera = view.camera;
  window.drag("cloud:deformed", 60, 20);
  window.settle();
  CHECK(view.camera.yaw != camera.yaw);
  CHECK_FALSE(window.window().picture() == before);
  window.key("1");
  window.settle();
  CHECK(std::abs(view.camera.yaw) < 1e-9);
}

TEST_CASE("A click on a point takes its shape, everywhere; on nothing it lets all go") {
  TestWindow window;
  show_fitted_chairs(window, 5);
  Studio& studio = window.studio();
  for (const bool deformed : {false, true}) {
    CAPTURE(deformed);
    const std::size_t point = front_point(window, deformed);
    const CloudContent& content = *studio.cloud.content;
    const ShapeId shape = content.shapes[content.of[point].shape].id;
    const ImVec2 at = place_of(window, point, deformed);
    ImGui::GetIO().MousePos = at;
    window.frames(3);
    CHECK(studio.ui.selection.hovered == shape);
    CHECK(studio.cloud.marked);  // shown apart from the others
    ImGui::GetIO().MouseDown[0] = true;
    window.frames();
    window.let_go();
    window.settle();
    CHECK(studio.ui.selection.shapes == std::vector{shape});
    CHECK(studio.ui.shape == shape);
    if (content.of[point].part != null_label) {
      REQUIRE(studio.ui.selection.place);
      CHECK(studio.ui.selection.place->shape == shape);
      const Vec3 canonical = studio.ui.selection.place->canonical;
      CHECK((canonical.cast<float>() - Eigen::Vector3f(content.points->moved[point].x,
                                                       content.points->moved[point].y,
                                                       content.points->moved[point].z))
                .norm() < 1e-5F);
    }
    const Target pane = target_of(window, "cloud");
    ImGui::GetIO().MousePos = {pane.low_x + 4, pane.high_y - 60};
    window.frames(2);
    ImGui::GetIO().MouseDown[0] = true;
    window.frames();
    window.let_go();
    CHECK(studio.ui.selection.shapes.empty());
    window.frames(2);
    CHECK_FALSE(studio.cloud.marked);
  }
}

TEST_CASE("The slider blends from rigid to deformed; colours and scope are chosen above it") {
  TestWindow window;
  show_fitted_chairs(window, 4);
  Studio& studio = window.studio();
  window.click("command:cloud-pair");
  window.settle();
  CHECK_FALSE(window.has("cloud:deformed"));
  const Picture deformed = window.window().picture();
  window.press_on("cloud:blend");  // in its middle
  window.let_go();
  window.settle();
  CHECK(studio.ui.cloud.blend > 0.3F);
  CHECK(studio.ui.cloud.blend < 0.7F);
  CHECK_FALSE(window.window().picture() == deformed);
  window.drag("cloud:blend", -150, 0);
  CHECK(studio.ui.cloud.blend == 0);

  const auto by_part = studio.cloud.colours;
  window.click("command:cloud-by-shape");
  window.settle();
  CHECK(*studio.cloud.colours != *by_part);
  window.click("command:cloud-by-displacement");
  window.settle();
  const CloudContent& content = *studio.cloud.content;
  const auto most = std::ranges::max_element(content.displacement) - content.displacement.begin();
  const auto least = std::ranges::min_element(content.displacement) - content.displacement.begin();
  CHECK((*studio.cloud.colours)[static_cast<std::size_t>(most)][0] >
        (*studio.cloud.colours)[static_cast<std::size_t>(least)][0]);

  select_only(studio.ui.selection, {content.shapes[1].id, content.shapes[2].id});
  window.click("cloud:scope");
  window.frames(2);
  window.click("cloud:scope:Selected shapes (2)");
  window.settle();
  CHECK(studio.cloud.content->shapes.size() == 2);
  run(window, "cloud-of", {"collection"});
  CHECK(studio.cloud.content->shapes.size() == 4);
  CHECK_FALSE(run_command(studio, "cloud-of", std::vector<std::string>{"no such template"}));
  CHECK_FALSE(run_command(studio, "cloud-blend", std::vector<std::string>{"2"}));
  run(window, "cloud-boxes");
}

TEST_CASE("Large clouds are drawn in part while they turn, and whole once they rest") {
  TestWindow window(700, 500);
  show_fitted_chairs(window, 1, 1000);
  Studio& studio = window.studio();
  // As if the shape had come 300 times: more points than one frame draws.
  auto content = std::make_shared<CloudContent>(*studio.cloud.content);
  auto points = std::make_shared<PointGeometry>(*content->points);
  const PointGeometry one = *content->points;
  const std::vector<CloudPoint> of = content->of;
  for (int i = 1; i < 300; ++i) {
    points->positions.insert(points->positions.end(), one.positions.begin(), one.positions.end());
    points->moved.insert(points->moved.end(), one.moved.begin(), one.moved.end());
    points->normals.insert(points->normals.end(), one.normals.begin(), one.normals.end());
    content->of.insert(content->of.end(), of.begin(), of.end());
  }
  content->displacement.resize(content->of.size(), 0.F);
  content->points = points;
  studio.cloud.content = content;
  window.settle();
  CHECK(studio.cloud.pictures[0].whole);
  run_command(studio, "turn-cloud", std::vector<std::string>{"3"});
  window.frames(2);
  CHECK_FALSE(studio.cloud.pictures[0].whole);
  window.settle();
  CHECK(studio.cloud.pictures[0].whole);
  CHECK(studio.cloud.pictures[1].whole);
  run(window, "report-cloud");
}

TEST_CASE("Ten thousand rows whose project is not there are no more than a message") {
  TestWindow window;
  Studio& studio = window.studio();
  studio.collection.path = window.scratch().path() / "gone.archetype";
  for (ShapeId id = 1; id <= 10'000; ++id) {
    FitSummary fit;
    fit.shape = id;
    fit.part_template = 1;
    fit.status = id % 100 == 0 ? FitStatus::outlier : FitStatus::fitted;
    studio.collection.content.rows.push_back({id, "shape_" + std::to_string(id), 1000, {}, fit});
  }
  ++studio.collection.revision;
  run(window, "show-cloud");
  CHECK(wanted_shapes(studio).shapes.size() == 9900);
  CHECK(studio.cloud.asked.outliers == 100);
  CHECK(studio.cloud.content == nullptr);
  window.frames(3);
}
