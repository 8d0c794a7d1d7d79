// What the view of a single fit shows: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/io/project.h"

namespace archetype {

// Surface and samples: by part, plain, or by a term of the energy.
enum class InspectColour { part, plain, shape_to_template, features, smoothness };

// One of the other templates and yaws that the shape was fitted with.
struct ChosenAlternative {
  TemplateId part_template = 0;
  int yaw_quarters = 0;
  friend bool operator==(const ChosenAlternative&, const ChosenAlternative&) = default;
};

struct InspectOptions {
  // Those of the settings; see kept_choices.h.
  InspectColour colour = InspectColour::part;
  bool fitted_boxes = true;
  bool mean_boxes = false;
  bool template_points = false;  // and how far each is from its correspondence
  bool correspondences = false;  // as lines
  bool samples = false;

  std::optional<ChosenAlternative> chosen;  // nothing: the fit that the project holds
  std::optional<std::size_t> step;          // after so many alternations; nothing: the end
  std::optional<ShapeId> beside;            // another shape, beside the one in view
  // The brush.
  bool painting = false;
  bool freeing = false;        // it takes pins away
  std::string paint_part;      // the name; "": no part
  double brush_radius = 0.15;  // normalised units
};

inline constexpr double least_brush_radius = 0.02;
inline constexpr double largest_brush_radius = 0.8;

}  // namespace archetype
