// Pictures larger than the graphics card draws at once.
#pragma once

#include <optional>

#include "core/base/job_control.h"
#include "render/renderer.h"

namespace archetype {

// The scene as Renderer::draw() would show it in `size`, drawn in pieces and put together; a backdrop with a
// fall of light would show the seams, so that only a transparent one is drawn as it is asked for, others as
// plain white. Nothing if cancelled. Holds the picture, 4 bytes a pixel, and one piece.
std::optional<Picture> draw_large_picture(Renderer& renderer, Scene scene, const Camera& camera,
                                          const PictureSize& size, const JobControl& control = {});

// Lays a picture, which may be transparent, over another one; what does not fit is cut off.
void lay_over(Picture& below, const Picture& above, int left, int top);

}  // namespace archetype
