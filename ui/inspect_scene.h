// The scene of one side of the view of a single fit: in the frame of the template, the shape moved into it.
#pragma once

#include "ui/inspection.h"

namespace archetype {

struct InspectContent {
  std::shared_ptr<const InspectedShape> shape;  // never null
  std::shared_ptr<const FitLook> look;          // null: the shape as it stands
  ShapeColours colours;
  InspectOptions options;
  std::optional<std::size_t> part;  // whose boxes and points are shown; nothing: all
  std::vector<PinnedLabel> pinned;  // for the template of the look
  Backdrop backdrop = Backdrop::dark;
};

// Of surface and samples; null where the fit has none, or the colour is plain. By part, `kept` keeps its
// colours while all others are dimmed.
ShapeColours inspect_colours(const FitLook& look, InspectColour by,
                             std::optional<std::size_t> kept = std::nullopt);
Scene make_inspect_scene(const InspectContent& content);
// Only what can be pointed at: the surface, or the samples where there is none.
Scene make_pick_scene(const InspectContent& content);
// From the shape's normalised coordinates to the scene.
glm::dvec3 in_scene(const FitLook* look, const Vec3& point);
Vec3 on_shape(const FitLook* look, const glm::dvec3& point);
// What a camera has to take in: the samples of the shape and the corners of its boxes.
std::vector<glm::vec3> inspected_points(const InspectContent& content);

}  // namespace archetype
