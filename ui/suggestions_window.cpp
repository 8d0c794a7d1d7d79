// Suggested templates as pictures of their boxes, the best first; a click takes one.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

#include "core/model/part_colours.h"
#include "ui/learning_actions.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

// From the front, right and above, as the grid shows shapes.
const Mat3 view = (Mat3() << 0.85, 0, -0.53, -0.2, 0.92, -0.33, 0.49, 0.39, 0.78).finished();

struct Face {
  double depth = 0;
  std::array<Vec3, 4> corners;  // seen from the view
  ImU32 colour = 0;
};

// The faces of the boxes that look at the viewer, the farthest first.
std::vector<Face> visible_faces(const PartTemplate& part_template) {
  std::vector<Face> faces;
  for (std::size_t k = 0; k < part_template.parts.size(); ++k) {
    const Box box = part_template.parts[k].mean_box();
    const Rgb rgb = part_colour(static_cast<int>(k));
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 normal = view * (box.orientation * Vec3::Unit(axis));
      const double side = normal.z() > 0 ? 1 : -1;
      const double light = 0.55 + 0.45 * std::max(0.0, side * normal.dot(Vec3(0.2, 0.8, 0.55)));
      Face face;
      for (int corner = 0; corner < 4; ++corner) {
        Vec3 local;
        local[axis] = side;
        local[(axis + 1) % 3] = corner == 0 || corner == 3 ? -1 : 1;
        local[(axis + 2) % 3] = corner < 2 ? -1 : 1;
        face.corners[static_cast<std::size_t>(corner)] = view * box.to_world(local);
        face.depth += face.corners[static_cast<std::size_t>(corner)].z() / 4;
      }
      const auto shade = [&](auto value) { return static_cast<int>(static_cast<double>(value) * light); };
      face.colour = IM_COL32(shade(rgb[0]), shade(rgb[1]), shade(rgb[2]), 235);
      faces.push_back(face);
    }
  }
  std::ranges::stable_sort(faces, {}, &Face::depth);
  return faces;
}

void draw_boxes(const PartTemplate& part_template, ImVec2 low, float side) {
  const std::vector<Face> faces = visible_faces(part_template);
  Bounds extent;
  for (const Face& face : faces) {
    for (const Vec3& corner : face.corners) extent.add(corner);
  }
  const Vec3 half = extent.half_extent();
  const double scale = 0.46 * side / std::max({half.x(), half.y(), 1e-6});
  const auto place = [&](const Vec3& p) {
    const Vec3 from_middle = scale * (p - extent.centre());
    return ImVec2(low.x + side / 2 + static_cast<float>(from_middle.x()),
                  low.y + side / 2 - static_cast<float>(from_middle.y()));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const Face& face : faces) {
    std::array<ImVec2, 4> at;
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = place(face.corners[i]);
    draw->AddQuadFilled(at[0], at[1], at[2], at[3], face.colour);
    draw->AddQuad(at[0], at[1], at[2], at[3], IM_COL32(0, 0, 0, 90));
  }
}

// True when it was clicked.
bool draw_suggestion(Studio& studio, std::size_t rank, float side) {
  const InitialTemplate& suggestion = studio.ui.suggestions[rank];
  ImGui::BeginGroup();
  ImGui::PushID(static_cast<int>(rank));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::Selectable("##take", false, 0, {side, side});
  mark_target(studio, "suggestion:" + std::to_string(rank + 1));
  draw_boxes(suggestion.part_template, at, side);
  ImGui::PopID();
  char text[64];
  std::snprintf(text, sizeof text, "%zu parts, energy %.3f", suggestion.part_template.parts.size(),
                suggestion.mean_energy);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + side);
  ImGui::TextUnformatted(suggestion.part_template.name.c_str());
  muted_text(studio, text);
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  return clicked;
}

}  // namespace

void draw_suggestions_window(Studio& studio) {
  if (!studio.ui.show_suggestions) return;
  const ImGuiViewport* screen = ImGui::GetMainViewport();
  const ImVec2 size(std::min(980 * studio.fonts.scale, screen->WorkSize.x * 0.94f),
                    std::min(540 * studio.fonts.scale, screen->WorkSize.y * 0.9f));
  ImGui::SetNextWindowPos(screen->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  if (ImGui::Begin("Suggested templates", &studio.ui.show_suggestions, ImGuiWindowFlags_NoCollapse)) {
    muted_paragraph(studio,
                    "Made from segmentations of some shapes, the one that fits the collection best first. "
                    "Click one to take it; learning makes it better.");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float side = (ImGui::GetContentRegionAvail().x - 4 * gap) / 5;
    for (std::size_t rank = 0; rank < studio.ui.suggestions.size(); ++rank) {
      if (rank % 5 != 0) ImGui::SameLine();
      if (!draw_suggestion(studio, rank, side)) continue;
      take_suggestion(studio, rank);
      studio.ui.show_suggestions = false;
    }
  }
  ImGui::End();
}

}  // namespace archetype
