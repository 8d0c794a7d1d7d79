// How the map of the collection is looked at, and what its sliders are at. Plain data.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/session/nearest_shapes.h"

namespace archetype {

enum class MapTool { rectangle, lasso };

// What is wished of the parts of one template, and the shapes that come nearest to it.
struct SliderState {
  std::optional<TemplateId> of;
  std::vector<PartWish> wishes;  // one per part
  // The nearest, found anew when what they depend on changes.
  std::vector<NearShape> nearest;
  std::shared_ptr<const FitTable> found_in;
  std::vector<PartWish> found_for;
};

struct MapState {
  std::filesystem::path project;  // that this is of
  std::optional<TemplateId> of;   // the map of its shapes only; nothing: of all
  // Those of the settings; see kept_choices.h.
  MapTool tool = MapTool::rectangle;
  bool pictures = true;
  bool sliders = true;
  // What is in the middle of the view, and how many screen units are as long as one of the map; found anew in
  // every frame while the whole map is shown, which is until it is zoomed or panned.
  bool whole = true;
  double x = 0;
  double y = 0;
  double zoom = 1;
  std::vector<ImVec2> outline;  // of the selection that is being drawn, screen units
  bool panning = false;
  SliderState slider;
  // Where shapes stand in the collection's rows.
  std::unordered_map<ShapeId, std::size_t> row_of;
  std::uint64_t rows_revision = 0;
};

}  // namespace archetype
