// The spread of a part, dragged.
#include "ui/spread_handles.h"

#include <doctest/doctest.h>

#include "tests/ui/viewport_window.h"
#include "ui/command.h"

using namespace archetype;
using namespace archetype::test;

namespace {

const TemplatePart& right_box(const Window& w) {
  return w.studio.history.current().active_template()->parts[1];
}

struct SpreadWindow : Window {
  SpreadWindow() {
    studio.ui.part = 1;
    run_command(studio, "spread");
    frames(2);
  }
  glm::dvec2 end_of(int axis, double stddev, bool of_size) const {
    const Box before = box(1);
    const double from = of_size ? before.half_extent[axis] : 0;
    return pixel_of(before.centre + (from + stddev) * Vec3::Unit(axis));
  }
};

}  // namespace

TEST_CASE("the ellipsoid and the dashed lines of a part are dragged to set its spread, as one step") {
  for (const bool of_size : {false, true})
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(of_size);
      CAPTURE(axis);
      SpreadWindow w;
      const auto of = of_size ? SpreadHandle::Of::size : SpreadHandle::Of::position;
      const Vec3 before = stddev_of(right_box(w), of);
      const TemplatePart start = right_box(w);
      const std::size_t steps = w.steps();
      w.press(w.end_of(axis, before[axis], of_size));
      REQUIRE(w.state.action == MouseAction::spread);
      w.move_to(w.end_of(axis, before[axis] + 0.1, of_size));
      CHECK(w.studio.history.has_preview());
      CHECK(w.steps() == steps);
      w.move_to(w.end_of(axis, before[axis] + 0.2, of_size));
      w.release();
      CHECK(w.steps() == steps + 1);
      Vec3 expected = before;
      expected[axis] += 0.2;
      CHECK((stddev_of(right_box(w), of) - expected).norm() < 0.02);
      CHECK(same(w.box(1), start.mean_box()));
      CHECK(w.studio.history.undo());
      CHECK(right_box(w) == start);
      CHECK(w.studio.history.redo());
      CHECK((stddev_of(right_box(w), of) - expected).norm() < 0.02);
    }
}

TEST_CASE(
    "Shift drags the spread of all axes in proportion, Esc puts it back, and it never becomes negative") {
  SpreadWindow w;
  set_position_stddev(w.studio.history, {1}, Vec3(0.3, 0.15, 0.6));
  w.frames(2);
  w.io.KeyShift = true;
  w.drag(w.end_of(0, 0.3, false), w.end_of(0, 0.6, false));
  w.io.KeyShift = false;
  CHECK((right_box(w).position.stddev - Vec3(0.6, 0.3, 1.2)).norm() < 0.1);

  const TemplatePart before = right_box(w);
  const std::size_t steps = w.steps();
  const double x = before.position.stddev.x();
  w.press(w.end_of(0, x, false));
  w.move_to(w.end_of(0, x + 0.3, false));
  REQUIRE(w.studio.history.has_preview());
  run_command(w.studio, "cancel");
  w.move_to(w.end_of(0, x + 0.5, false));
  w.release();
  CHECK(right_box(w) == before);
  CHECK(w.steps() == steps);

  w.drag(w.end_of(0, x, false), w.end_of(0, -1.5, false));
  CHECK(right_box(w).position.stddev.x() == doctest::Approx(min_half_extent));
  CHECK(w.state.action == MouseAction::none);
}

TEST_CASE("while the spread is shown a click still selects, and a drag beside the dots orbits") {
  SpreadWindow w;
  w.click(w.pixel_of(w.box(0).to_world(Vec3(-0.7, 0.7, 0.9))));
  CHECK(w.studio.ui.part == std::size_t{0});
  const Document before = w.studio.history.current();
  const Camera camera = w.state.pane().camera;
  w.drag({60, 60}, {160, 110});
  CHECK(w.state.pane().camera.yaw != camera.yaw);
  CHECK(w.studio.history.current() == before);
}
