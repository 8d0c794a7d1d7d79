// Keys from GLFW to commands and to Dear ImGui, none lost.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "ui/keys.h"

struct GLFWwindow;

namespace archetype {

// Dear ImGui 1.86 looks at which keys are down once a frame: a tap that begins and ends between two frames,
// or two taps of one key, would be lost. So at most one change of each key is handed on per frame, the others
// wait. What keys type waits in the same line: fields take it in before the keys of a frame, and not at all
// while Ctrl is down.
class KeyFeed {
 public:
  struct Event {
    int key, scancode, action, mods;
    unsigned character = 0;  // not 0: no key, but what one typed
  };

  void add(const Event& event) { events_.push_back(event); }
  // What is for this frame, in order; the rest waits.
  std::vector<Event> take();
  // Hands on what is for this frame; true if some had to wait for the next.
  bool feed(GLFWwindow* window);

 private:
  std::deque<Event> events_;
};

// What was pressed, by the letters that the keyboard's layout gives; nothing for modifiers on their own,
// releases and keys that no command can have.
std::optional<KeyChord> chord_of(const KeyFeed::Event& event);

}  // namespace archetype
