// What is drawn over the pictures of the clouds with Dear ImGui.
#pragma once

#include <imgui.h>

#include "render/camera.h"

namespace archetype {

struct Studio;

// Where a picture of the cloud stands in this frame, screen units.
struct CloudPane {
  std::size_t index = 0;  // of its picture
  float blend = 0;
  ImVec2 origin;
  ImVec2 size;
  Viewport viewport() const { return {static_cast<int>(size.x), static_cast<int>(size.y)}; }
};

// `last`: the pane that has the legend.
void draw_cloud_overlay(Studio& studio, const CloudPane& pane, bool last);

}  // namespace archetype
