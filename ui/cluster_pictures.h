// The pictures of templates: their mean boxes and the spread of these, seen as the thumbnails of the members
// are.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/project.h"
#include "render/renderer.h"

namespace archetype {

struct Studio;

// Everything that a picture depends on.
struct TemplatePicture {
  std::shared_ptr<const PartTemplate> part_template;
  std::optional<std::size_t> highlighted;
  bool spread = true;
  PictureSize size;
  Backdrop backdrop = Backdrop::dark;
  friend bool operator==(const TemplatePicture&, const TemplatePicture&) = default;
};

// Needs the window's OpenGL context when it dies.
struct ClusterPicture {
  RenderTarget target;
  std::optional<TemplatePicture> drawn;
  std::uint64_t used = 0;  // the frame
};
using ClusterPictures = std::map<TemplateId, ClusterPicture>;

// What the pictures of a template and of its members are framed by: the corners of its mean boxes, somewhat
// grown by their spread. Empty without parts.
std::vector<glm::vec3> framed_corners(const PartTemplate& part_template);

// Draws it at the cursor as a button, marked as `target`. A click takes the part that is under the mouse, or
// lets go of the parts where there is none.
void draw_cluster_picture(Studio& studio, const TemplateRecord& record, const std::string& target,
                          ImVec2 size);

}  // namespace archetype
