#include "ui/cluster_pictures.h"

#include <algorithm>
#include <cmath>

#include "render/convert.h"
#include "render/picking.h"
#include "render/thumbnails.h"
#include "ui/figure_scenes.h"
#include "ui/part_highlight.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

Scene make_scene(const TemplatePicture& wanted) {
  const bool one = wanted.highlighted.has_value();
  Scene scene = template_scene(
      *wanted.part_template,
      {.spread = wanted.spread, .highlighted = wanted.highlighted, .backdrop = wanted.backdrop});
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    SceneBox& box = scene.boxes[i];
    if (box.dash > 0) continue;
    const bool dimmed = one && wanted.highlighted != i;
    if (dimmed) box.fill = 0.06F;
    box.outline_width = dimmed ? 0.8F : 1.3F;
  }
  return scene;
}

Camera camera_of(const PartTemplate& part_template, const PictureSize& size) {
  const std::vector<glm::vec3> corners = framed_corners(part_template);
  return corners.empty() ? Camera{} : thumbnail_camera(corners, {size.width, size.height});
}

std::optional<std::size_t> part_under_mouse(const TemplatePicture& shown, ImVec2 low, float density) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const glm::dvec2 pixel((mouse.x - low.x) * density, (mouse.y - low.y) * density);
  const Ray ray =
      ray_through(camera_of(*shown.part_template, shown.size), {shown.size.width, shown.size.height}, pixel);
  Scene boxes;
  for (const TemplatePart& part : shown.part_template->parts) boxes.boxes.push_back({.box = part.mean_box()});
  const std::vector<Pick> picks = pick_boxes(boxes, ray);
  return picks.empty() ? std::nullopt : std::optional(picks.front().object);
}

}  // namespace

std::vector<glm::vec3> framed_corners(const PartTemplate& part_template) {
  std::vector<glm::vec3> corners;
  for (const TemplatePart& part : part_template.parts) {
    const Vec3 spread = (part.position.stddev.cwiseAbs2() + part.scale.stddev.cwiseAbs2()).cwiseSqrt();
    Box box = part.mean_box();
    // A template made by hand knows nothing of its spread yet: its shapes must not be drawn tiny.
    box.half_extent += spread.cwiseMin(0.12);
    for (int corner = 0; corner < 8; ++corner)
      corners.emplace_back(to_glm(box.to_world(
          {(corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0})));
  }
  return corners;
}

void draw_cluster_picture(Studio& studio, const TemplateRecord& record, const std::string& target,
                          ImVec2 size) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float density = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 1.0f);
  ClusterPicture& picture = studio.cluster_pictures[record.id];
  TemplatePicture wanted;
  const bool same = picture.drawn && *picture.drawn->part_template == record.part_template;
  wanted.part_template =
      same ? picture.drawn->part_template : std::make_shared<const PartTemplate>(record.part_template);
  wanted.highlighted = highlighted_part(studio, record.part_template);
  wanted.spread = studio.ui.clusters.spread;
  wanted.size = {std::max(1, static_cast<int>(std::lround(size.x * density))),
                 std::max(1, static_cast<int>(std::lround(size.y * density))), 1,
                 density * studio.fonts.scale};
  wanted.backdrop = studio.theme == Theme::light ? Backdrop::light : Backdrop::dark;
  if (picture.drawn != wanted) {
    studio.viewport.renderer.draw(make_scene(wanted), camera_of(*wanted.part_template, wanted.size),
                                  wanted.size, picture.target);
    picture.drawn = wanted;
  }
  const bool clicked = ImGui::InvisibleButton(target.c_str(), size);
  mark_target(studio, target);
  const auto texture = static_cast<std::intptr_t>(picture.target.texture().name());
  ImGui::GetWindowDrawList()->AddImageRounded(reinterpret_cast<ImTextureID>(texture), low,
                                              {low.x + size.x, low.y + size.y}, {0, 1}, {1, 0},
                                              IM_COL32_WHITE, 6 * studio.fonts.scale);
  if (!ImGui::IsItemHovered()) return;
  const std::optional<std::size_t> part = part_under_mouse(*picture.drawn, low, density);
  if (part) ImGui::SetTooltip("%s", record.part_template.parts[*part].name.c_str());
  if (clicked) select_part_of(studio, record, part);
}

}  // namespace archetype
