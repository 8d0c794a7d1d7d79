// What the viewport shows: the shape, coloured by its fit, with the boxes of the template over it.
//
// The scene stands in the template's frame: boxes are where their numbers say, and the shape is turned by the
// yaw that the fit found. It is not shifted by the fit's translation: that would make it swim below the boxes
// while one of them is dragged.
#pragma once

#include <memory>
#include <optional>

#include "render/scene.h"
#include "ui/average_shape.h"
#include "ui/shape_display.h"
#include "ui/ui_state.h"

namespace archetype {

// Colours of what is drawn, by part or as a heat map; null where the fit has none for it.
struct ShapeColours {
  std::shared_ptr<const Colours> elements;  // faces, or points of a point set
  std::shared_ptr<const Colours> samples;
};
// `kept`: the part that keeps its colours while all others are dimmed; one that is not there dims all.
ShapeColours colours_of_fit(const ViewFit& fit, const ShapeDisplay& display,
                            SurfaceColour by = SurfaceColour::part, std::optional<int> kept = std::nullopt);

// The corners of the shape as it is drawn, turned by its fit; nothing where there is none.
std::optional<std::pair<glm::dvec3, glm::dvec3>> shape_extent(const ShapeDisplay& display,
                                                              const ViewFit* fit);

struct ViewportContent {
  const PartTemplate* part_template = nullptr;  // may be null
  const PartTemplate* compared = nullptr;       // another one, to compare with; may be null
  const ViewFit* fit = nullptr;                 // may be null, or of an older template
  ShapeDisplay display;
  ShapeColours colours;
  const AverageShape* average = nullptr;  // may be null
  ViewOptions view;
  std::optional<std::size_t> selected;
  std::vector<std::size_t> also_selected;
  std::optional<std::size_t> hovered;
  bool moving = false;  // quick rather than exact: a large mesh is drawn coarser
  Backdrop backdrop = Backdrop::dark;
};

// The first boxes of the scene are those of the template's parts, in their order, if view.mean_boxes is on.
Scene make_viewport_scene(const ViewportContent& content);

// The corners of what "frame" brings into the picture: the selected box, or the shape and all boxes; nothing
// if there is neither.
std::optional<std::pair<glm::dvec3, glm::dvec3>> extent_to_frame(const ViewportContent& content);

}  // namespace archetype
