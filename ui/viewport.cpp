#include "ui/viewport.h"

#include <imgui.h>

#include "render/thumbnails.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {

void draw_viewport(Studio& studio) {
  ViewportState& state = studio.viewport;
  if (!studio.shape.record) {
    empty_hint(studio, "No shape in view", "Click a shape in the collection on the left.");
    return;
  }
  if (state.shape_revision != studio.shape.shape_revision) {
    state.shape_revision = studio.shape.shape_revision;
    state.mesh.reset();
    if (studio.shape.mesh)
      state.mesh = std::make_shared<const MeshGeometry>(
          make_mesh_geometry(*studio.shape.mesh, studio.shape.record->frame));
  }
  if (state.fit_revision != studio.shape.fit_revision) {
    state.fit_revision = studio.shape.fit_revision;
    state.colours.reset();
    if (studio.shape.fit) state.colours = colours_of_labels(studio.shape.fit->element_labels);
  }
  Scene scene;
  scene.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  if (state.mesh) scene.meshes.push_back({.geometry = state.mesh, .face_colours = state.colours});
  const ImVec2 size = ImGui::GetContentRegionAvail();
  state.renderer.draw(scene, state.camera,
                      {.width = static_cast<int>(size.x), .height = static_cast<int>(size.y)}, state.target);
  ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(state.target.texture().name())), size,
               {0, 1}, {1, 0});
}

}  // namespace archetype
