#include "ui/typed_transform.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>

#include "render/convert.h"
#include "ui/edit_overlay.h"
#include "ui/selection.h"
#include "ui/snapping.h"
#include "ui/studio.h"
#include "ui/viewport_mouse.h"

namespace archetype {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_arm = 12;  // pixels from the middle to the cursor, at scale 1

// Nothing as long as it is no number yet: "", "-", ".".
std::optional<double> number_of(const std::string& typed) {
  double value = 0;
  const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), value);
  if (error != std::errc() || end != typed.data() + typed.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

Vec3 axis_of(const Box& box, int k) {
  return box.orientation * Vec3(Vec3::Unit(k));
}

Box scaled(const TypedTransform& transform, double factor) {
  Box box = transform.held;
  for (int k = 0; k < 3; ++k)
    if (!transform.axis || *transform.axis == k)
      box.half_extent[k] = std::max(box.half_extent[k] * std::abs(factor), min_half_extent);
  return box;
}

Box turned(const TypedTransform& transform, double angle, const Vec3& about) {
  Box box = transform.held;
  box.orientation = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, about)) * box.orientation).normalized();
  return box;
}

Box typed_box(const TypedTransform& transform, double value) {
  const Box& held = transform.held;
  switch (transform.kind) {
    case BoxTool::scale:
      return scaled(transform, value);
    case BoxTool::rotate:
      return turned(transform, value * degree, axis_of(held, transform.axis.value_or(1)));
    case BoxTool::move:
      break;
  }
  Box box = held;
  box.centre += value * axis_of(held, transform.axis.value_or(0));
  return box;
}

BoxDrag drag_of(const TypedTransform& transform) {
  const HandleKind kind = transform.kind == BoxTool::rotate ? HandleKind::rotate : HandleKind::move_view;
  return {{kind, transform.axis.value_or(1), {}}, transform.held, transform.grabbed.value_or(glm::dvec2(0))};
}

void end(Studio& studio) {
  studio.ui.transform.reset();
  studio.viewport.snapped.reset();
}

std::string axis_name(const TypedTransform& transform, int otherwise) {
  const int axis = transform.axis.value_or(otherwise);
  return axis < 0 ? "" : std::string(1, static_cast<char>('x' + axis));
}

}  // namespace

void begin_transform(Studio& studio, BoxTool kind) {
  if (studio.ui.transform) {
    studio.ui.transform->kind = kind;
    studio.ui.transform->grabbed.reset();
    studio.ui.transform->typed.clear();
    return;
  }
  TypedTransform transform;
  transform.kind = kind;
  transform.start = selected_boxes(studio);
  const std::optional<Box> held = held_box(transform.start);
  if (!held) return;
  transform.held = transform.now = *held;
  studio.viewport.snap_planes = snap_planes(studio, transform.start);
  studio.ui.transform = std::move(transform);
}

void cancel_transform(Studio& studio) {
  if (!studio.ui.transform) return;
  if (studio.ui.transform->previewed) studio.history.cancel_preview();
  end(studio);
}

bool take_transform_key(Studio& studio, const KeyChord& chord) {
  if (!studio.ui.transform || chord.ctrl || chord.alt) return false;
  std::string& typed = studio.ui.transform->typed;
  if (chord.key == "Enter") {
    studio.ui.transform->confirmed = true;
  } else if (chord.key == "Backspace") {
    if (!typed.empty()) typed.pop_back();
  } else if (chord.key == "-" || chord.key == "+") {
    if (typed.starts_with('-'))
      typed.erase(0, 1);
    else if (chord.key == "-")
      typed.insert(0, 1, '-');
  } else if (chord.key == "." || chord.key == ",") {
    if (typed.find('.') == std::string::npos) typed += typed.empty() || typed == "-" ? "0." : ".";
  } else if (chord.key.size() == 1 && std::isdigit(static_cast<unsigned char>(chord.key[0]))) {
    if (typed.size() < 12) typed += chord.key;
  } else {
    return false;
  }
  return true;
}

Box transformed_box(const TypedTransform& transform, const GizmoView& view, const glm::dvec2& cursor,
                    bool steps) {
  if (const auto value = number_of(transform.typed)) return typed_box(transform, *value);
  if (!transform.typed.empty() || !transform.grabbed) return transform.held;
  if (transform.kind == BoxTool::move)
    return dragged_box(drag_of(transform), view, cursor, {.steps = steps, .only_axis = transform.axis});
  const auto middle = to_screen(view.camera, view.viewport, to_glm(transform.held.centre));
  if (!middle) return transform.held;
  const glm::dvec2 from = *transform.grabbed - *middle;
  const glm::dvec2 to = cursor - *middle;
  if (transform.kind == BoxTool::scale) {
    double factor = glm::length(to) / std::max(glm::length(from), least_arm * view.scale);
    if (steps) factor = std::round(10 * factor) / 10;
    return scaled(transform, factor);
  }
  if (glm::length(from) < 1 || glm::length(to) < 1) return transform.held;
  // The screen's y points down, so this is the angle against the clock.
  double angle = std::atan2(from.y * to.x - from.x * to.y, glm::dot(from, to));
  const Vec3 towards = to_eigen(back_axis(view.camera));
  const Vec3 about = transform.axis ? axis_of(transform.held, *transform.axis) : towards;
  if (about.dot(towards) < 0) angle = -angle;
  if (steps) angle = std::round(angle / (15 * degree)) * 15 * degree;
  return turned(transform, angle, about);
}

void follow_transform(Studio& studio, const MouseInput& mouse, const GizmoView& view) {
  TypedTransform& transform = *studio.ui.transform;
  const bool dropped = transform.previewed && !studio.history.has_preview();
  if (dropped || !still_selected(studio, transform.start)) {
    if (!dropped) cancel_transform(studio);
    end(studio);
    return;
  }
  if (mouse.pressed && mouse.button == ImGuiMouseButton_Right) return cancel_transform(studio);
  if (mouse.over && !transform.grabbed) transform.grabbed = mouse.cursor;
  Box box = transformed_box(transform, view, mouse.cursor, mouse.shift);
  studio.viewport.snapped.reset();
  const bool led_by_mouse = transform.typed.empty();
  const bool can_snap =
      transform.kind == BoxTool::move || (transform.kind == BoxTool::rotate && transform.axis);
  if (led_by_mouse && can_snap && studio.ui.snapping != mouse.ctrl) {
    studio.viewport.snapped = snapped(box, drag_of(transform), {.only_axis = transform.axis},
                                      studio.viewport.snap_planes, snap_reach(view, box.centre));
    box = studio.viewport.snapped->box;
  }
  transform.now = box;
  const std::vector<PlacedPart> placed = carried(transform.start, transform.held, box);
  const bool keep = transform.confirmed || (mouse.pressed && mouse.button == ImGuiMouseButton_Left);
  if (transform.previewed && keep) studio.history.cancel_preview();
  set_part_boxes(studio.history, placed, keep ? Stage::done : Stage::live);
  transform.previewed = studio.history.has_preview();
  if (keep) end(studio);
}

std::string transform_text(const TypedTransform& transform, const Box& now) {
  char number[64];
  std::string text;
  const Box& held = transform.held;
  switch (transform.kind) {
    case BoxTool::move: {
      const std::string axis = axis_name(transform, transform.typed.empty() ? -1 : 0);
      text = axis.empty() ? "Move" : "Move along " + axis;
      const Vec3 way = held.orientation.conjugate() * (now.centre - held.centre);
      if (axis.empty())
        std::snprintf(number, sizeof number, "%.3f  %.3f  %.3f", way.x(), way.y(), way.z());
      else
        std::snprintf(number, sizeof number, "%.3f", way[axis[0] - 'x']);
      break;
    }
    case BoxTool::scale: {
      const std::string axis = axis_name(transform, -1);
      text = axis.empty() ? "Scale" : "Scale along " + axis;
      const int k = axis.empty() ? 0 : axis[0] - 'x';
      std::snprintf(number, sizeof number, "× %.3f", now.half_extent[k] / held.half_extent[k]);
      break;
    }
    case BoxTool::rotate: {
      const std::string axis = axis_name(transform, transform.typed.empty() ? -1 : 1);
      text = axis.empty() ? "Rotate" : "Rotate about " + axis;
      const Eigen::AngleAxisd turn(now.orientation * held.orientation.conjugate());
      const bool back = !axis.empty() && turn.axis().dot(axis_of(held, axis[0] - 'x')) < 0;
      std::snprintf(number, sizeof number, "%.1f°", (back ? -1 : 1) * turn.angle() / degree);
      break;
    }
  }
  return text + ":  " + (transform.typed.empty() ? number : transform.typed + "_");
}

void draw_transform(Studio& studio, ImDrawList& draw, ImVec2 origin, const GizmoView& view,
                    const ScreenRect& taken) {
  if (!studio.ui.transform) return;
  const TypedTransform& transform = *studio.ui.transform;
  if (transform.axis)
    draw_axis_line(draw, origin, transform.held.centre, axis_of(transform.held, *transform.axis),
                   *transform.axis, view);
  draw_strip(draw, origin, view, taken, transform_text(transform, transform.now),
             "X Y Z axis  ·  type a number  ·  Enter keeps  ·  Esc puts back");
}

}  // namespace archetype
