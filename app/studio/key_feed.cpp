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

}  // namespace

bool KeyFeed::feed(GLFWwindow* window) {
  std::set<int> changed;
  while (!events_.empty() && changed.insert(events_.front().key).second) {
    const Event event = events_.front();
    events_.pop_front();
    ImGui_ImplGlfw_KeyCallback(window, event.key, event.scancode, event.action, event.mods);
  }
  return !events_.empty();
}

std::optional<KeyChord> chord_of(const KeyFeed::Event& event) {
  if (event.action == GLFW_RELEASE) return std::nullopt;
  std::string name = key_name(event.key, event.scancode);
  if (name == "=" && (event.mods & GLFW_MOD_CONTROL))
    name = "+";  // the same key without Shift on most keyboards
  std::optional<KeyChord> chord = name.empty() ? std::nullopt : parse_chord(name);
  if (!chord) return std::nullopt;
  chord->ctrl = (event.mods & GLFW_MOD_CONTROL) != 0;
  chord->shift = (event.mods & GLFW_MOD_SHIFT) != 0 && name != "+";
  chord->alt = (event.mods & GLFW_MOD_ALT) != 0;
  return chord;
}

}  // namespace archetype
