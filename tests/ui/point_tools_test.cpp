// Boxes from the shape, drawn and clicked in the window.
#include "ui/point_tools.h"

#include <doctest/doctest.h>

#include <set>

#include "core/base/random.h"
#include "core/session/actions.h"
#include "render/convert.h"
#include "tests/ui/test_window.h"
#include "ui/selection.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

struct Chair : TestWindow {
  Chair() {
    open_chairs(1);
    add_template(studio().history, {.name = "chair", .parts = {}, .extra_json = {}}, "New");
    settle();
    steps = studio().history.entries().size();
  }
  Target area() {
    for (const Target& target : studio().targets)
      if (target.name == "viewport") return target;
    FAIL("no viewport");
    return {};
  }
  GizmoView view() {
    const Target t = area();
    GizmoView result;
    result.camera = studio().viewport.pane().camera;
    result.viewport = {static_cast<int>(t.high_x - t.low_x), static_cast<int>(t.high_y - t.low_y)};
    return result;
  }
  void move_to(const glm::dvec2& pixel) {
    const Target t = area();
    ImGui::GetIO().MousePos = {t.low_x + static_cast<float>(pixel.x), t.low_y + static_cast<float>(pixel.y)};
    frames(2);
  }
  void press() {
    ImGui::GetIO().MouseDown[0] = true;
    frames();
  }
  // The rectangle on the screen around all that is drawn of the shape.
  std::pair<glm::dvec2, glm::dvec2> around_all() {
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    const GizmoView v = view();
    for (const Vec3& point : points_in_view(studio())) {
      const glm::dvec2 pixel = *to_screen(v.camera, v.viewport, to_glm(point));
      low = glm::min(low, pixel);
      high = glm::max(high, pixel);
    }
    return {low - 6.0, high + 6.0};
  }
  void drag_around(const glm::dvec2& low, const glm::dvec2& high) {
    move_to(low);
    press();
    move_to(0.5 * (low + high));
    move_to(high);
    let_go();
  }
  const std::vector<TemplatePart>& parts() { return studio().history.current().active_template()->parts; }
  std::size_t steps = 0;
};

bool holds(const Box& box, const std::vector<Vec3>& points) {
  for (const Vec3& point : points)
    if (box.to_local(point).cwiseAbs().maxCoeff() > 1 + 1e-9) return false;
  return true;
}

}  // namespace

TEST_CASE("A rectangle selects points, and a box is put around them") {
  Chair chair;
  chair.key("Q");
  CHECK(chair.studio().ui.points.tool == PointTool::rectangle);
  const auto [low, high] = chair.around_all();
  chair.drag_around(low, high);
  CHECK(chair.studio().ui.points.tool == PointTool::none);
  const std::size_t all = chair.studio().shape.samples->size();
  CHECK(selected_points(chair.studio()).size() == all);
  CHECK(chair.studio().history.entries().size() == chair.steps);
  chair.key("Shift+D");
  REQUIRE(chair.parts().size() == 1);
  CHECK(holds(chair.parts()[0].mean_box(), points_in_view(chair.studio())));
  CHECK(chair.studio().ui.part == 0);
  chair.key("Escape");
  CHECK(selected_points(chair.studio()).empty());
  // Half of them, then the other half with Ctrl out of all.
  chair.key("Q");
  chair.drag_around(low, {high.x, 0.5 * (low.y + high.y)});
  const std::size_t upper = selected_points(chair.studio()).size();
  CHECK(upper > all / 10);
  CHECK(upper < all);
  chair.key("Q");
  ImGui::GetIO().KeyShift = true;
  chair.drag_around({low.x, 0.5 * (low.y + high.y)}, high);
  ImGui::GetIO().KeyShift = false;
  CHECK(selected_points(chair.studio()).size() == all);
  chair.key("Q");
  ImGui::GetIO().KeyCtrl = true;
  chair.drag_around(low, {high.x, 0.5 * (low.y + high.y)});
  ImGui::GetIO().KeyCtrl = false;
  CHECK(selected_points(chair.studio()).size() == all - upper);
}

TEST_CASE("A box drawn on the shape is as wide as what is under it, and one step") {
  Chair chair;
  chair.key("D");
  const auto [low, high] = chair.around_all();
  const glm::dvec2 middle = 0.5 * (low + high);
  chair.drag_around(low, middle);
  REQUIRE(chair.parts().size() == 1);
  CHECK(chair.studio().ui.points.tool == PointTool::none);
  CHECK(chair.studio().history.entries().size() == chair.steps + 1);
  const Document after = chair.studio().history.current();
  chair.key("Ctrl+Z");
  CHECK(chair.parts().empty());
  chair.key("Ctrl+Shift+Z");
  CHECK(chair.studio().history.current() == after);
  // A click draws nothing; Esc lays the tool down in the middle of a drag.
  chair.key("D");
  chair.move_to(middle);
  chair.press();
  chair.let_go();
  CHECK(chair.parts().size() == 1);
  chair.press();
  chair.move_to(high);
  chair.key("Escape");
  chair.let_go();
  CHECK(chair.parts().size() == 1);
  CHECK(chair.studio().ui.points.tool == PointTool::none);
}

TEST_CASE("A lasso takes what its line encloses only") {
  Chair chair;
  chair.key("Shift+Q");
  const auto [low, high] = chair.around_all();
  chair.move_to(low);
  chair.press();
  for (const glm::dvec2& corner : {glm::dvec2(high.x, low.y), high}) chair.move_to(corner);
  chair.let_go();
  const std::size_t count = selected_points(chair.studio()).size();
  CHECK(count > 0);
  CHECK(count < chair.studio().shape.samples->size());
}

TEST_CASE("Pieces and segments of the surface get a box by a click on them") {
  for (const char* key : {"J", "A"}) {
    CAPTURE(key);
    Chair chair;
    chair.key(key);
    chair.settle();
    REQUIRE(chair.studio().ui.points.regions);
    const SurfaceRegions regions = *chair.studio().ui.points.regions;
    CHECK(regions.boxes.size() > 2);
    const std::size_t count = points_in_view(chair.studio()).size();
    std::set<std::size_t> clicked;
    for (std::size_t i = 0; i < count; i += count / 12) {
      select_only(chair.studio().ui, std::nullopt);  // no handles in the way
      chair.settle();
      // The shape does not turn under boxes that were made on it.
      if (const auto& fit = chair.studio().shape.fit) CHECK(fit->fit.yaw_quarters == 0);
      const std::vector<Vec3> points = points_in_view(chair.studio());
      const GizmoView view = chair.view();
      const std::size_t before = chair.parts().size();
      chair.move_to(*to_screen(view.camera, view.viewport, to_glm(points[i])));
      const std::optional<std::size_t> hovered = chair.studio().ui.points.hovered;
      REQUIRE(hovered);
      chair.press();
      chair.let_go();
      if (!clicked.insert(*hovered).second) {
        CHECK(chair.parts().size() == before);  // it has its box already
        CHECK(chair.studio().ui.part);
        continue;
      }
      REQUIRE(chair.parts().size() == before + 1);
      std::vector<Vec3> region;
      for (std::size_t k = 0; k < points.size(); ++k)
        if (regions.of_sample[k] == static_cast<int>(*hovered)) region.push_back(points[k]);
      if (std::string(key) == "J") CHECK(holds(chair.parts().back().mean_box(), region));
    }
    CHECK(chair.parts().size() == clicked.size());
    CHECK(clicked.size() > 2);
    chair.key("Escape");
    CHECK(chair.studio().ui.points.tool == PointTool::none);
  }
}

TEST_CASE("The box of a leaning back is turned about one axis, though its outline is no rectangle") {
  const Eigen::Quaterniond leaning(Eigen::AngleAxisd(-0.3, Vec3::UnitX()));
  auto samples = std::make_shared<ShapeSamples>();
  samples->radius = 1;
  for (int i = -20; i <= 20; ++i)
    for (int k = -26; k <= 26; ++k)
      if (i + k < 30)  // a corner is cut off: the longest way is across
        for (const double z : {-0.05, 0.05}) samples->points.push_back(leaning * Vec3(0.05 * i, 0.05 * k, z));
  const auto found = find_surface_regions({RegionKind::component, nullptr, samples, 1}, {});
  REQUIRE(found);
  REQUIRE(found->boxes.size() == 1);
  const Box& box = found->boxes[0];
  CHECK(std::abs(box.orientation.y()) < 1e-9);
  CHECK(std::abs(box.orientation.z()) < 1e-9);
  CHECK(box.orientation.angularDistance(leaning) < 0.02);
  CHECK(holds(box, samples->points));
}

TEST_CASE("The box of a leg that is splayed both ways stays as thin as the leg") {
  const Eigen::Quaterniond splayed =
      Eigen::AngleAxisd(0.15, Vec3::UnitX()) * Eigen::AngleAxisd(0.15, Vec3::UnitZ());
  auto samples = std::make_shared<ShapeSamples>();
  samples->radius = 1;
  for (int i = 0; i <= 100; ++i)
    for (int corner = 0; corner < 4; ++corner)
      samples->points.push_back(splayed * Vec3((corner & 1) != 0 ? 0.05 : -0.05, 0.015 * i - 0.75,
                                               (corner & 2) != 0 ? 0.05 : -0.05));
  const auto found = find_surface_regions({RegionKind::component, nullptr, samples, 1}, {});
  REQUIRE(found);
  REQUIRE(found->boxes.size() == 1);
  const Vec3 half = found->boxes[0].half_extent;
  CHECK(half.y() == doctest::Approx(0.75).epsilon(0.02));
  CHECK(half.x() < 0.075);  // twisted about itself: 0.071
  CHECK(half.z() < 0.075);
}

TEST_CASE("A tool that is laid down before its regions are there leaves nothing under way") {
  Chair chair;
  take_point_tool(chair.studio(), PointTool::segment);
  chair.frames();
  take_point_tool(chair.studio(), PointTool::segment);
  CHECK(chair.studio().ui.points.tool == PointTool::none);
  chair.settle();
  CHECK(under_way(chair.studio()).empty());
}

TEST_CASE("A part grows to the points that it is given, and shrinks to those inside") {
  Chair chair;
  add_part(chair.studio().history, {Vec3::Zero(), Vec3::Constant(4), Eigen::Quaterniond::Identity()});
  chair.studio().ui.part = 0;
  chair.settle();
  chair.key("Shift+T");
  const std::vector<Vec3> points = points_in_view(chair.studio());
  const Box tight = chair.parts()[0].mean_box();
  CHECK(holds(tight, points));
  CHECK(tight.half_extent.maxCoeff() < 3);
  set_part_box(chair.studio().history, 0, {tight.centre, Vec3::Constant(0.05), tight.orientation});
  chair.settle();
  chair.key("Q");
  const auto [low, high] = chair.around_all();
  chair.drag_around(low, high);
  chair.key("Shift+G");
  const Box grown = chair.parts()[0].mean_box();
  CHECK((grown.half_extent - tight.half_extent).norm() < 1e-9);
}

TEST_CASE("Points inside of an outline, and those of the front") {
  GizmoView view;
  view.viewport = {400, 400};
  view.camera.yaw = view.camera.pitch = 0;
  const std::vector<Vec3> points{{0, 0, 1}, {0.1, 0, 0.9}, {0, 0.1, -1}, {0.9, 0.9, 0}};
  const std::vector<std::uint32_t> in =
      points_inside(points, {{150, 150}, {250, 150}, {250, 250}, {150, 250}}, view);
  CHECK(in == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(front_points(points, in, view, 0.5).size() == 2);
  CHECK(front_points(points, in, view, 5).size() == 3);
}
