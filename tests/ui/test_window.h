// The whole window without a display, with hands: the mouse is really moved over what is drawn and pressed
// there, and Dear ImGui's own hit testing decides what was meant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"
#include "ui/headless_window.h"

namespace archetype::test {

class TestWindow {
 public:
  explicit TestWindow(int width = 1280, int height = 720, float scale = 1);

  Studio& studio() { return window_.studio(); }
  const ScratchFolder& scratch() const { return scratch_; }
  HeadlessWindow& window() { return window_; }

  void frames(int count = 1);
  // Frames until nothing is under way; fails the test after a minute.
  void settle();

  bool has(const std::string& target);
  // Fails the test if there is no such target in the frame.
  void click(const std::string& target);
  void double_click(const std::string& target);
  // Pressed on the target, moved in steps, let go.
  void drag(const std::string& target, float dx, float dy, int steps = 8);
  void press_on(const std::string& target);
  void move_by(float dx, float dy);
  void let_go();
  void type(const std::string& text);  // into what has the keyboard
  void key(const std::string& chord);  // to the commands: "Ctrl+Z"
  void field_key(ImGuiKey key);        // to Dear ImGui: ImGuiKey_Enter

  // Of a picture of the grid. Names of textures tell nothing: a deleted one's may be given to the next.
  std::vector<std::uint8_t> pixels_of(std::uint32_t texture);

  // A collection of generated chairs, imported and in view.
  void open_chairs(std::size_t count);
  // A template of a seat, a back and a leg, as the user would have loaded it.
  void make_template();

 private:
  Target find(const std::string& name);

  ScratchFolder scratch_;
  HeadlessWindow window_;
};

}  // namespace archetype::test
