#include "tests/ui/test_window.h"

#include <doctest/doctest.h>
#include <epoxy/gl.h>

#include <chrono>
#include <thread>

#include "core/generate/generate.h"
#include "core/session/actions.h"
#include "ui/project_actions.h"
#include "ui/thumbnail_worker.h"

namespace archetype::test {
namespace {

StudioOptions options_in(const std::filesystem::path& folder) {
  StudioOptions options;
  options.folders = {folder, folder / "config", folder / "data", folder / "cache"};
  options.assets = std::filesystem::path(ARCHETYPE_SOURCE_DIR) / "assets";
  options.shaders = std::filesystem::path(ARCHETYPE_SOURCE_DIR) / "shaders";
  options.furniture = folder / "no-furniture";
  return options;
}

}  // namespace

TestWindow::TestWindow(int width, int height, float scale)
    : window_(width, height, scale, options_in(scratch_.path())) {
  frames(3);
}

void TestWindow::frames(int count) {
  for (int i = 0; i < count; ++i) window_.frame();
}

void TestWindow::settle() {
  const auto start = std::chrono::steady_clock::now();
  frames(3);
  while (!settled(studio())) {
    INFO("under way: " << std::string(under_way(studio())));
    REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::minutes(3));  // stuck, not slow
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    frames();
  }
  frames(2);
}

Target TestWindow::find(const std::string& name) {
  for (const Target& target : studio().targets)
    if (target.name == name) return target;
  FAIL("there is no " << name << " in the window");
  return {};
}

bool TestWindow::has(const std::string& target) {
  for (const Target& each : studio().targets)
    if (each.name == target) return true;
  return false;
}

void TestWindow::press_on(const std::string& target) {
  const Target at = find(target);
  ImGui::GetIO().MousePos = {(at.low_x + at.high_x) / 2, (at.low_y + at.high_y) / 2};
  frames(2);  // what is under the mouse is known one frame after it came there
  ImGui::GetIO().MouseDown[0] = true;
  frames();
}

void TestWindow::let_go() {
  ImGui::GetIO().MouseDown[0] = false;
  frames(2);
}

void TestWindow::move_by(float dx, float dy) {
  ImGui::GetIO().MousePos.x += dx;
  ImGui::GetIO().MousePos.y += dy;
  frames();
}

void TestWindow::click(const std::string& target) {
  press_on(target);
  let_go();
}

void TestWindow::double_click(const std::string& target) {
  press_on(target);
  let_go();
  ImGui::GetIO().MouseDown[0] = true;
  frames();
  let_go();
}

void TestWindow::drag(const std::string& target, float dx, float dy, int steps) {
  press_on(target);
  for (int i = 0; i < steps; ++i) move_by(dx / static_cast<float>(steps), dy / static_cast<float>(steps));
  let_go();
}

void TestWindow::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  frames(2);
}

void TestWindow::key(const std::string& chord) {
  const auto parsed = parse_chord(chord);
  REQUIRE(parsed.has_value());
  studio().pressed_keys.push_back(*parsed);
  frames(2);
}

void TestWindow::field_key(ImGuiKey key) {
  bool& down = ImGui::GetIO().KeysDown[ImGui::GetKeyIndex(key)];
  down = true;
  frames();
  down = false;
  frames(2);
}

std::vector<std::uint8_t> TestWindow::pixels_of(std::uint32_t texture) {
  std::vector<std::uint8_t> pixels(4 * thumbnail_size * thumbnail_size);
  REQUIRE(texture != 0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

void TestWindow::open_chairs(std::size_t count) {
  const std::filesystem::path folder = scratch_.path() / "chairs";
  GenerateOptions options;
  options.count = count;
  write_collection("chairs", options, folder, {});
  open_folder(studio(), folder / "shapes");
  settle();
  REQUIRE(studio().collection.rows().size() == count);
}

void TestWindow::make_template() {
  PartTemplate chair;
  chair.name = "chair";
  const auto part = [&](const char* name, const Vec3& centre, const Vec3& half_extent) {
    TemplatePart made;
    made.name = name;
    made.label = static_cast<int>(chair.parts.size());
    made.position.mean = centre;
    made.scale.mean = half_extent;
    chair.parts.push_back(made);
  };
  part("seat", {0, -0.1, 0.1}, {0.6, 0.08, 0.6});
  part("back", {0, 0.7, -0.5}, {0.6, 0.6, 0.08});
  part("leg", {0.5, -0.8, 0.5}, {0.07, 0.6, 0.07});
  add_template(studio().history, chair, "Make a chair");
  settle();
}

}  // namespace archetype::test
