// A window with two boxes, and a hand at its mouse.
#pragma once

#include <doctest/doctest.h>
#include <imgui.h>

#include <glm/geometric.hpp>
#include <string>

#include "core/session/actions.h"
#include "render/convert.h"
#include "tests/support/scratch_folder.h"
#include "ui/headless_window.h"
#include "ui/viewport.h"

namespace archetype::test {

inline PartTemplate two_boxes() {
  PartTemplate boxes;
  boxes.name = "two";
  for (const double x : {-0.7, 0.7}) {
    TemplatePart part;
    part.name = x < 0 ? "left" : "right";
    part.position.mean = Vec3(x, 0, 0);
    part.scale.mean = Vec3(0.4, 0.5, 0.3);
    boxes.parts.push_back(part);
  }
  return boxes;
}

// A window with two boxes, seen from three quarters.
struct Window {
  ScratchFolder folder;
  HeadlessWindow window{1200, 800, 1, options()};
  Studio& studio = window.studio();
  ViewportState& state = studio.viewport;
  ImGuiIO& io = ImGui::GetIO();

  Window() {
    add_template(studio.history, two_boxes(), "Two boxes");
    io.MousePos = {-1, -1};
    state.pane().camera.distance = 6;
    frames(2);
  }

  StudioOptions options() const {
    StudioOptions result;
    const auto& path = folder.path();
    result.folders = {path, path / "config", path / "data", path / "cache"};
    result.assets = std::filesystem::path(ARCHETYPE_SOURCE_DIR) / "assets";
    result.shaders = std::filesystem::path(ARCHETYPE_SOURCE_DIR) / "shaders";
    result.furniture = path / "none";
    return result;
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) window.frame();
  }
  Target area() const {
    for (const Target& target : studio.targets)
      if (target.name == "viewport") return target;
    FAIL("the viewport was not drawn");
    return {};
  }
  GizmoView view() const {
    const Target t = area();
    return {state.pane().camera,
            {static_cast<int>(t.high_x - t.low_x), static_cast<int>(t.high_y - t.low_y)},
            static_cast<double>(studio.fonts.scale)};
  }
  glm::dvec2 pixel_of(const Vec3& place) const {
    const GizmoView v = view();
    return *to_screen(v.camera, v.viewport, to_glm(place));
  }
  void move_to(const glm::dvec2& pixel) {
    const Target t = area();
    // Dear ImGui rounds to whole pixels.
    io.MousePos = {t.low_x + static_cast<float>(pixel.x), t.low_y + static_cast<float>(pixel.y)};
    frames(2);
  }
  void press(const glm::dvec2& pixel, int button = 0) {
    move_to(pixel);
    io.MouseDown[button] = true;
    frames(1);
  }
  void release(int button = 0) {
    io.MouseDown[button] = false;
    frames(1);
  }
  void click(const glm::dvec2& pixel) {
    press(pixel);
    release();
  }
  void drag(const glm::dvec2& from, const glm::dvec2& to, int button = 0) {
    press(from, button);
    for (const double t : {0.3, 0.6, 1.0}) move_to(glm::mix(from, to, t));
    release(button);
  }
  Box box(std::size_t part) const {
    return studio.history.current().active_template()->parts[part].mean_box();
  }
  std::size_t steps() const { return studio.history.entries().size(); }
  std::optional<Handle> handle_at(const glm::dvec2& pixel) {
    move_to(pixel);
    return state.handle;
  }
};

inline bool same(const Box& a, const Box& b, double tolerance = 1e-9) {
  return (a.centre - b.centre).norm() < tolerance && (a.half_extent - b.half_extent).norm() < tolerance &&
         (a.orientation.coeffs() - b.orientation.coeffs()).norm() < tolerance;
}

}  // namespace archetype::test
