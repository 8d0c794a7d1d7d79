// Keys and what they type reach the fields in the order in which they came, however long frames take.
#include "app/studio/key_feed.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include <string>

using namespace archetype;

namespace {

void press(KeyFeed& feed, int key, int mods = 0) {
  feed.add({key, 0, GLFW_PRESS, mods});
}
void release(KeyFeed& feed, int key, int mods = 0) {
  feed.add({key, 0, GLFW_RELEASE, mods});
}
void tap(KeyFeed& feed, int key, int mods = 0) {
  press(feed, key, mods);
  release(feed, key, mods);
}
void type(KeyFeed& feed, char letter) {
  press(feed, letter);
  feed.add({0, 0, 0, 0, static_cast<unsigned>(letter)});
  release(feed, letter);
}

// What a field holds in the end: in a frame it takes characters, unless Ctrl is down, and then the keys.
std::string field_after(KeyFeed& feed, std::string text) {
  bool ctrl = false;
  bool all = false;  // is selected
  for (int frame = 0; frame < 100; ++frame) {
    const auto events = feed.take();
    if (events.empty()) return text;
    std::string typed;
    std::vector<int> pressed;
    for (const KeyFeed::Event& event : events) {
      if (event.character != 0) typed += static_cast<char>(event.character);
      if (event.character == 0 && event.key == GLFW_KEY_LEFT_CONTROL) ctrl = event.action == GLFW_PRESS;
      if (event.character == 0 && event.action == GLFW_PRESS) pressed.push_back(event.key);
    }
    if (!typed.empty() && !ctrl) {
      if (all) text.clear();
      all = false;
      text += typed;
    }
    for (const int key : pressed) {
      if (key == 'A' && ctrl) all = true;
      if (key == GLFW_KEY_BACKSPACE && !text.empty()) text.pop_back();
      if (key == GLFW_KEY_ENTER) text += '.';
    }
  }
  return "endless";
}

}  // namespace

TEST_CASE("No tap is lost: each change of a key has a frame of its own") {
  KeyFeed feed;
  for (int i = 0; i < 3; ++i) tap(feed, 'Z', GLFW_MOD_CONTROL);
  int presses = 0;
  for (int frame = 0; frame < 6; ++frame) {
    const auto events = feed.take();
    REQUIRE(events.size() == 1);
    presses += events[0].action == GLFW_PRESS;
  }
  CHECK(presses == 3);
  CHECK(feed.take().empty());
}

TEST_CASE(
    "What is typed in one frame after Ctrl+A, or about a Backspace, comes in the order it was typed in") {
  KeyFeed feed;
  press(feed, GLFW_KEY_LEFT_CONTROL);
  tap(feed, 'A', GLFW_MOD_CONTROL);
  release(feed, GLFW_KEY_LEFT_CONTROL);
  for (const char letter : std::string("clusters")) type(feed, letter);
  tap(feed, GLFW_KEY_ENTER);
  CHECK(field_after(feed, "figure") == "clusters.");
  type(feed, 'x');
  tap(feed, GLFW_KEY_BACKSPACE);
  type(feed, 'y');
  type(feed, 'y');
  CHECK(field_after(feed, "") == "yy");
}
