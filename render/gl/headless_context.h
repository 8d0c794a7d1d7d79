// OpenGL without a display: tests, --screenshot on a server, thumbnails beside the window.
#pragma once

#include <mutex>

namespace archetype::gl {

// One thread at a time while it lives: who draws with a HeadlessContext beside those of other threads holds
// it for each picture. Mesa's software renderer (22.3) looks through what the other contexts of a display
// draw without locking it: two threads that draw at once crash some time, within minutes where they do
// nothing else. May be held several times by one thread.
class HeadlessTurn {
 public:
  HeadlessTurn();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

// An OpenGL 3.3 core context through EGL that has no surface: only framebuffers can be drawn into. Current on
// the thread that makes it, for as long as it lives; must die there. Takes a turn to be made and to die.
class HeadlessContext {
 public:
  // Throws Error, with what to install, where EGL or OpenGL 3.3 is missing.
  HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;
  ~HeadlessContext();

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace archetype::gl
