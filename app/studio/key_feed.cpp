#include "app/studio/key_feed.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <set>
#include <string>

namespace archetype {
namespace {

std::string key_name(int key, int scancode) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
    return std::to_string(key - GLFW_KEY_F1 + 1).insert(0, 1, 'F');
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return std::to_string(key - GLFW_KEY_KP_0);
  switch (key) {
    case GLFW_KEY_ESCAPE:
      return "Escape";
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return "Enter";
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_BACKSPACE:
      return "Backspace";
    case GLFW_KEY_INSERT:
      return "Insert";
    case GLFW_KEY_DELETE:
      return "Delete";
    case GLFW_KEY_RIGHT:
      return "Right";
    case GLFW_KEY_LEFT:
      return "Left";
    case GLFW_KEY_DOWN:
      return "Down";
    case GLFW_KEY_UP:
      return "Up";
    case GLFW_KEY_PAGE_UP:
      return "PageUp";
    case GLFW_KEY_PAGE_DOWN:
      return "PageDown";
    case GLFW_KEY_HOME:
      return "Home";
    case GLFW_KEY_END:
      return "End";
    case GLFW_KEY_SPACE:
      return "Space";
    case GLFW_KEY_KP_ADD:
      return "+";
    case GLFW_KEY_KP_SUBTRACT:
      return "-";
    default:
      break;
  }
  const char* printed = glfwGetKeyName(key, scancode);
  return printed ? printed : "";
}

bool types(int key) {
  return key < GLFW_KEY_ESCAPE ||
         (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL && key != GLFW_KEY_KP_ENTER);
}

bool is_shift(int key) {
  return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT;
}

}  // namespace

std::vector<KeyFeed::Event> KeyFeed::take() {
  std::vector<Event> taken;
  std::set<int> changed;
  bool typed = false;       // a character in this frame
  bool controlled = false;  // a key that a field heeds itself, such as Backspace, was pressed in this frame
  for (; !events_.empty(); events_.pop_front()) {
    const Event& event = events_.front();
    if (event.character != 0) {
      if (controlled) break;
      typed = true;
    } else {
      if (typed && !types(event.key)) break;
      if (!changed.insert(event.key).second) break;
      const bool plain = types(event.key) && (event.mods & GLFW_MOD_CONTROL) == 0;
      controlled = controlled || (event.action != GLFW_RELEASE && !plain && !is_shift(event.key));
    }
    taken.push_back(event);
  }
  return taken;
}

bool KeyFeed::feed(GLFWwindow* window) {
  for (const Event& event : take()) {
    if (event.character != 0)
      ImGui_ImplGlfw_CharCallback(window, event.character);
    else
      ImGui_ImplGlfw_KeyCallback(window, event.key, event.scancode, event.action, event.mods);
  }
  return !events_.empty();
}

std::optional<KeyChord> chord_of(const KeyFeed::Event& event) {
  if (event.action == GLFW_RELEASE) return std::nullopt;
  const std::string printed = key_name(event.key, event.scancode);
  // Where both are on one key, as on most keyboards, + is meant by it without Shift, too.
  const bool plus = printed == "=" && (event.mods & GLFW_MOD_CONTROL) != 0;
  const std::string name = plus ? "+" : printed;
  std::optional<KeyChord> chord = name.empty() ? std::nullopt : parse_chord(name);
  if (!chord) return std::nullopt;
  chord->ctrl = (event.mods & GLFW_MOD_CONTROL) != 0;
  chord->shift = (event.mods & GLFW_MOD_SHIFT) != 0 && name != "+";
  chord->alt = (event.mods & GLFW_MOD_ALT) != 0;
  return chord;
}

}  // namespace archetype
