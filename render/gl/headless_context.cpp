// OpenGL without a display, through EGL.
#include "render/gl/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <string>

#include "core/base/error.h"

namespace archetype::gl {
namespace {

constexpr const char* advice = "; on Debian install libegl-mesa0 and libgl1-mesa-dri";

// Mesa opens without any device; NVIDIA's own driver wants one of its devices.
EGLDisplay open_display() {
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint i = 0; i < count; ++i) {
      EGLDisplay display =
          eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr);
      if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    }
  }
  return EGL_NO_DISPLAY;
}

std::recursive_mutex& turns() {
  static std::recursive_mutex one;
  return one;
}

}  // namespace

HeadlessTurn::HeadlessTurn() : lock_(turns()) {}

HeadlessContext::HeadlessContext() {
  const HeadlessTurn turn;
  EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY) throw Error(std::string("cannot open EGL without a display") + advice);
  const std::array config_wishes{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  const std::array context_wishes{EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display, config_wishes.data(), &config, 1, &count) ||
      count == 0)
    throw Error(std::string("EGL offers no OpenGL") + advice);
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_wishes.data());
  if (context == EGL_NO_CONTEXT) throw Error(std::string("EGL offers no OpenGL 3.3 core context") + advice);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    eglDestroyContext(display, context);
    throw Error(std::string("EGL cannot draw without a surface") + advice);
  }
  display_ = display;
  context_ = context;
}

HeadlessContext::~HeadlessContext() {
  const HeadlessTurn turn;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  // The display is shared by all contexts of the process and is not counted: it stays open.
}

}  // namespace archetype::gl
