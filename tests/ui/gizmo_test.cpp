// Drags against what they should do to the box: the cursor goes to where a known change would put the handle.
#include "ui/gizmo.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/random.h"
#include "core/session/actions.h"
#include "render/convert.h"

using namespace archetype;

namespace {

constexpr Viewport viewport{900, 700};

Box some_box(RandomStream& random, bool turned = true) {
  const auto within = [&](double r) {
    return Vec3(random.uniform(-r, r), random.uniform(-r, r), random.uniform(-r, r));
  };
  Box box{within(0.5), Vec3(0.3, 0.3, 0.3) + within(0.2), Eigen::Quaterniond::Identity()};
  if (turned)
    box.orientation = Eigen::Quaterniond(1, within(0.5).x(), within(0.5).y(), within(0.5).z()).normalized();
  return box;
}

GizmoView some_view(RandomStream& random) {
  GizmoView view;
  view.viewport = viewport;
  view.camera.yaw = random.uniform(-3, 3);
  view.camera.pitch = random.uniform(-1.4, 1.4);
  view.camera.distance = random.uniform(2.5, 8);
  view.camera.orthographic = random.uniform() < 0.3;
  return view;
}

glm::dvec2 pixel_of(const GizmoView& view, const Vec3& place) {
  const auto pixel = to_screen(view.camera, view.viewport, to_glm(place));
  REQUIRE(pixel);
  return *pixel;
}

// Whether an axis is seen well enough from the side for a drag along it to be told.
bool seen_from_side(const GizmoView& view, const Vec3& place, const Vec3& axis) {
  const Vec3 towards = (to_eigen(eye(view.camera)) - place).normalized();
  return std::abs(axis.normalized().dot(towards)) < 0.9;
}

void check_same(const Box& a, const Box& b) {
  CHECK((a.centre - b.centre).norm() < 1e-6);
  CHECK((a.half_extent - b.half_extent).norm() < 1e-6);
  CHECK(std::abs(a.orientation.dot(b.orientation)) > 1 - 1e-9);
}

Vec3 axis_of(const Box& box, int k) {
  return box.orientation * Vec3(Vec3::Unit(k));
}

}  // namespace

TEST_CASE("every side is resized against the opposite one, in the box's own axes") {
  RandomStream random(1);
  int checked = 0;
  for (int round = 0; round < 40; ++round)
    for (int code = 0; code < 27; ++code) {
      const std::array<int, 3> side{code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
      const Vec3 sides(side[0], side[1], side[2]);
      const int count = static_cast<int>(sides.cwiseAbs().sum());
      if (count == 0) continue;
      const Box box = some_box(random);
      const GizmoView view = some_view(random);
      const Vec3 place = box.to_world(sides);
      const bool about_centre = round % 2 == 1;
      // A corner goes along its diagonal, the others freely along their axes.
      const double share = random.uniform(-0.3, 0.6);
      Vec3 out;
      bool usable = true;
      for (int k = 0; k < 3; ++k) {
        out[k] = sides[k] == 0 ? 0 : count == 3 ? share * box.half_extent[k] : random.uniform(-0.08, 0.4);
        if (sides[k] == 0 && count == 2) usable = !seen_from_side(view, place, axis_of(box, k));
        if (sides[k] != 0 && count == 1) usable = seen_from_side(view, place, axis_of(box, k));
      }
      if (count == 3) usable = seen_from_side(view, place, box.to_world(sides) - box.centre);
      if (!usable) continue;
      ++checked;
      Box expected = box;
      expected.half_extent += about_centre ? out : Vec3(0.5 * out);
      if (!about_centre) expected.centre += box.orientation * Vec3(0.5 * out.cwiseProduct(sides));
      const Vec3 to = place + box.orientation * Vec3(out.cwiseProduct(sides));
      const BoxDrag drag{{HandleKind::resize, 0, side}, box, pixel_of(view, place)};
      const Box result = dragged_box(drag, view, pixel_of(view, to), {.about_centre = about_centre});
      check_same(result, expected);
      if (!about_centre) CHECK((result.to_world(-sides) - box.to_world(-sides)).norm() < 1e-6);
    }
  CHECK(checked > 300);
}

TEST_CASE("boxes move along an axis, in a plane and in that of the screen") {
  RandomStream random(2);
  for (int round = 0; round < 200; ++round) {
    const Box box = some_box(random);
    const GizmoView view = some_view(random);
    const int k = round % 3;
    const double a = random.uniform(-0.6, 0.6);
    const double b = random.uniform(-0.6, 0.6);
    const glm::dvec2 from = pixel_of(view, box.centre);
    Box expected = box;
    if (seen_from_side(view, box.centre, axis_of(box, k))) {
      expected.centre = box.centre + a * axis_of(box, k);
      const glm::dvec2 to = pixel_of(view, expected.centre);
      check_same(dragged_box({{HandleKind::move_axis, k, {}}, box, from}, view, to, {}), expected);
      // The same by holding any handle that moves to the axis.
      check_same(dragged_box({{HandleKind::move_view, 0, {}}, box, from}, view, to, {.only_axis = k}),
                 expected);
    } else {
      expected.centre = box.centre + a * axis_of(box, (k + 1) % 3) + b * axis_of(box, (k + 2) % 3);
      check_same(dragged_box({{HandleKind::move_plane, k, {}}, box, from}, view,
                             pixel_of(view, expected.centre), {}),
                 expected);
    }
    expected.centre = box.centre + to_eigen(a * right_axis(view.camera) + b * up_axis(view.camera));
    check_same(
        dragged_box({{HandleKind::move_view, 0, {}}, box, from}, view, pixel_of(view, expected.centre), {}),
        expected);
  }
}

TEST_CASE("rings turn the box by the angle that the cursor goes round") {
  RandomStream random(3);
  for (int round = 0; round < 100; ++round) {
    const Box box = some_box(random);
    const GizmoView view = some_view(random);
    const int k = round % 3;
    if (seen_from_side(view, box.centre, axis_of(box, k))) continue;
    const double angle = random.uniform(-2, 2);
    const Eigen::AngleAxisd turn(angle, axis_of(box, k));
    const Vec3 arm = 0.3 * axis_of(box, (k + 1) % 3);
    Box expected = box;
    expected.orientation = Eigen::Quaterniond(turn) * box.orientation;
    const BoxDrag drag{{HandleKind::rotate, k, {}}, box, pixel_of(view, box.centre + arm)};
    const glm::dvec2 to = pixel_of(view, box.centre + turn * arm);
    check_same(dragged_box(drag, view, to, {}), expected);
    const double stepped = Eigen::AngleAxisd(dragged_box(drag, view, to, {.steps = true}).orientation *
                                             box.orientation.conjugate())
                               .angle() *
                           180 / M_PI / 15;
    CHECK(stepped == doctest::Approx(std::round(stepped)).epsilon(1e-6));
  }
}

TEST_CASE("sizes never become negative, however far the cursor goes") {
  RandomStream random(4);
  for (int round = 0; round < 300; ++round) {
    const Box box = some_box(random);
    const GizmoView view = some_view(random);
    const int code = round % 27;
    const std::array<int, 3> side{code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
    if (code == 13) continue;
    const BoxDrag drag{
        {HandleKind::resize, 0, side}, box, pixel_of(view, box.to_world(Vec3(side[0], side[1], side[2])))};
    const glm::dvec2 far(random.uniform(-9000, 9000), random.uniform(-9000, 9000));
    for (const bool about_centre : {false, true}) {
      const Box result = dragged_box(drag, view, far, {.about_centre = about_centre});
      CHECK(result.half_extent.minCoeff() >= min_half_extent);
      CHECK(result.half_extent.allFinite());
      CHECK(result.centre.allFinite());
    }
  }
}

TEST_CASE("a drag that returns to its start gives the box back, also in steps") {
  RandomStream random(5);
  const Box box = some_box(random);
  const GizmoView view = some_view(random);
  for (const BoxTool tool : {BoxTool::move, BoxTool::scale, BoxTool::rotate})
    for (const HandleShape& shape : handle_shapes(box, tool, view))
      for (const bool steps : {false, true})
        check_same(dragged_box({shape.handle, box, {310, 200}}, view, {310, 200}, {.steps = steps}), box);
}

TEST_CASE("steps are multiples of a twentieth") {
  RandomStream random(6);
  const Box box = some_box(random, false);
  GizmoView view;
  view.viewport = viewport;
  const Box moved =
      dragged_box({{HandleKind::move_axis, 0, {}}, box, {400, 300}}, view, {531, 300}, {.steps = true});
  const double steps = (moved.centre.x() - box.centre.x()) / 0.05;
  CHECK(std::abs(steps) > 1);
  CHECK(steps == doctest::Approx(std::round(steps)));
}

TEST_CASE("each handle is found where it is drawn, and nothing far from all") {
  RandomStream random(7);
  const Box box{Vec3(0.1, 0, 0), Vec3(0.5, 0.9, 0.6)};
  GizmoView view;
  view.viewport = viewport;
  view.camera.distance = 6;
  for (const BoxTool tool : {BoxTool::move, BoxTool::scale, BoxTool::rotate}) {
    const auto shapes = handle_shapes(box, tool, view);
    if (tool == BoxTool::move)
      CHECK(shapes.size() > 13 + 9);  // without those on the far side, and one or two below arrows
    else
      CHECK(shapes.size() == (tool == BoxTool::scale ? 26 : 3));
    for (const HandleShape& shape : shapes) {
      glm::dvec2 at = shape.points[0];
      if (shape.form == HandleForm::square) at = 0.5 * (shape.points[0] + shape.points[2]);
      if (shape.form == HandleForm::arrow) at = glm::mix(shape.points[0], shape.points[1], 0.9);
      const auto found = find_handle(shapes, view, at);
      REQUIRE(found);
      if (!shape.faint && shape.form != HandleForm::ring) CHECK(*found == shape.handle);
    }
    CHECK_FALSE(find_handle(shapes, view, {5, 5}));
  }
}

TEST_CASE("on a thin box edges and corners give way to faces, which always stay") {
  GizmoView view;
  view.viewport = viewport;
  const auto count = [&](double thickness) {
    const Box box{Vec3::Zero(), Vec3(0.5, 0.5, thickness)};
    std::array<int, 4> sides{};
    for (const HandleShape& shape : handle_shapes(box, BoxTool::scale, view))
      ++sides.at(3 - static_cast<std::size_t>(std::ranges::count(shape.handle.side, 0)));
    return sides;
  };
  CHECK(count(0.5) == std::array{0, 6, 12, 8});
  CHECK(count(0.04)[1] == 6);
  CHECK(count(0.04)[2] < 12);
}

TEST_CASE("handles keep their size on the screen at any distance and grow with the screen's scale") {
  const Box box{Vec3::Zero(), Vec3(0.5, 0.5, 0.5)};
  const auto arrow = [&](double distance, double scale) {
    GizmoView view;
    view.viewport = viewport;
    view.camera.orthographic = true;
    view.camera.distance = distance;
    view.scale = scale;
    for (const HandleShape& shape : handle_shapes(box, BoxTool::move, view))
      if (shape.form == HandleForm::arrow) return glm::length(shape.points[1] - shape.points[0]);
    return 0.0;
  };
  CHECK(arrow(3, 1) > 30);
  CHECK(arrow(30, 1) == doctest::Approx(arrow(3, 1)));
  CHECK(arrow(3, 2) == doctest::Approx(2 * arrow(3, 1)));
}

TEST_CASE("a box behind the eye has no handles") {
  GizmoView view;
  view.viewport = viewport;
  const Box box{to_eigen(eye(view.camera) + back_axis(view.camera)), Vec3(0.1, 0.1, 0.1)};
  for (const BoxTool tool : {BoxTool::move, BoxTool::scale, BoxTool::rotate})
    CHECK(handle_shapes(box, tool, view).empty());
}
