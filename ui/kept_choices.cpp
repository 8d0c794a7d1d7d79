#include "ui/kept_choices.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ui/studio.h"

namespace archetype {
namespace {

constexpr std::array<std::pair<std::string_view, InspectColour>, 5> colour_names{
    {{"part", InspectColour::part},
     {"plain", InspectColour::plain},
     {"distance", InspectColour::shape_to_template},
     {"features", InspectColour::features},
     {"smoothness", InspectColour::smoothness}}};

}  // namespace

std::optional<InspectColour> find_inspect_colour(std::string_view name) {
  const auto found =
      std::ranges::find(colour_names, name, &std::pair<std::string_view, InspectColour>::first);
  return found == colour_names.end() ? std::nullopt : std::optional(found->second);
}

std::string_view name_of(InspectColour colour) {
  return std::ranges::find(colour_names, colour, &std::pair<std::string_view, InspectColour>::second)->first;
}

void follow_kept_choices(Studio& studio) {
  const Settings& kept = studio.settings;
  MapState& map = studio.ui.map;
  map.tool = kept.map_tool == "lasso" ? MapTool::lasso : MapTool::rectangle;
  map.pictures = kept.map_pictures;
  map.sliders = kept.map_sliders;
  studio.ui.plots.chosen = kept.plot;
  InspectOptions& inspect = studio.ui.inspect;
  inspect.colour = find_inspect_colour(kept.inspect_colour).value_or(InspectColour::part);
  inspect.fitted_boxes = kept.inspect_fitted_boxes;
  inspect.mean_boxes = kept.inspect_mean_boxes;
  inspect.template_points = kept.inspect_template_points;
  inspect.correspondences = kept.inspect_correspondences;
  inspect.samples = kept.inspect_samples;
}

}  // namespace archetype
