// OpenGL without a display: tests, --screenshot on a server, thumbnails beside the window.
#pragma once

#include <string>

namespace archetype::gl {

// An OpenGL 3.3 core context through EGL that has no surface: only framebuffers can be drawn into. Current on
// the thread that makes it, for as long as it lives; must die there.
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
