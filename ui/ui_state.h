// What the window shows and how: plain data, not undoable. What shall last is kept in the settings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/project.h"
#include "core/learning/initial_templates.h"
#include "ui/centre_views.h"
#include "ui/closing.h"
#include "ui/cloud_choice.h"
#include "ui/clusters_state.h"
#include "ui/collection.h"
#include "ui/explorer_selection.h"
#include "ui/inspect_options.h"
#include "ui/key_changes.h"
#include "ui/plots_state.h"
#include "ui/point_tools.h"
#include "ui/shape_map_state.h"
#include "ui/shown_shapes.h"
#include "ui/template_look.h"
#include "ui/typed_transform.h"

namespace archetype {

// Cost: the samples, by how badly the template explains them.
enum class SurfaceColour { part, plain, cost };

// The switches of the View menu.
struct ViewOptions {
  bool surface = true;
  bool wireframe = false;
  bool points = false;        // the samples
  bool mean_boxes = true;     // of the template: what is edited
  bool fitted_boxes = false;  // as deformed to the shape in view
  bool part_names = true;
  bool ground = true;
  bool average = false;       // of the collection, as a ghost behind the shape
  bool spread = false;        // of the parts: ellipsoids for their positions, dashed lines for their sizes
  bool orthographic = false;  // of the view in perspective
  bool four_views = false;    // perspective, top, front and right at once
  SurfaceColour colour = SurfaceColour::part;
  friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

enum class CameraView { front, back, left, right, top, bottom, home };
enum class Navigation { archetype, blender, maya };  // which buttons orbit, pan and zoom

struct GridState {
  bool scroll_to_shape = false;        // bring the shape in view into sight, once
  std::optional<float> wanted_scroll;  // from the top, screen units; of scripts
  float scroll = 0;                    // that it has now
  float most_scroll = 0;
};

struct PaletteState {
  bool open = false;
  bool newly_open = false;
  std::string query;
  std::size_t chosen = 0;
};

// What the file browser was opened for: the command that gets the path.
struct BrowseFor {
  std::string command = {};  // "open-folder", …
  std::string title = {};
  bool folders_only = false;
  bool saving = false;
  bool replaces = true;       // while saving: offers to replace a file that is there
  bool shapes = false;        // files that can be imported, and folders
  bool figure = false;        // while saving: asks for the width too, and whether it is transparent
  std::string ending = {};    // ".json": only these files are shown, and it is added when saving; "" for all
  std::string proposed = {};  // while saving: a name to begin with
};

struct FileBrowserState {
  BrowseFor wanted;
  bool open = false;
  bool newly_open = false;
  std::filesystem::path folder;
  std::string typed;  // the field: a name in the folder, or a path
  bool asked_to_replace = false;
  int figure_width = 2400;  // pixels
  bool transparent = false;
};

// A suggested template, and the shape whose segmentation it was made of.
struct SuggestionSource {
  ShapeSamples samples;
  ShapeFit fit;
};
struct Suggestion {
  InitialTemplate found;
  std::shared_ptr<const SuggestionSource> source;  // null: the shape is not known
};

// What is chosen in the learning panel.
struct LearningChoice {
  std::optional<std::size_t> round;          // nothing: the newest one
  std::optional<std::size_t> part_template;  // of that round
  bool bring_into_sight = true;              // once: it was chosen where its column may be out of sight
};

// The shapes of the strip, in its order.
struct StripChoice {
  std::vector<ShapeId> shapes;
  std::uint64_t draws = 0;  // so many were drawn at random: the seed of the newest
  bool emptied = false;     // by hand: it is not filled by itself again
};

enum class BottomTab { jobs, filter, strip, learning, messages, history, diagnostics };

struct UiState {
  CentreView centre = CentreView::shape;
  ExplorerSelection selection;
  CloudChoice cloud;
  InspectOptions inspect;
  std::optional<ShapeId> shape;            // the shape in view
  std::optional<std::size_t> part;         // the selected part of the active template; see ui/selection.h
  std::vector<std::size_t> also_selected;  // parts that are edited with it; empty without it
  std::vector<TemplatePart> copied_parts;  // to be pasted, into this template or another
  std::string compared;                    // the name of a template to compare with; "": none
  ViewOptions view;
  BoxTool tool = BoxTool::move;
  bool snapping = false;                    // dragged boxes snap; Ctrl held turns it round
  std::optional<TypedTransform> transform;  // G, S or R was pressed
  PointToolState points;
  std::optional<int> drag_axis;  // of the box, 0 to 2: the drag under way keeps to it (X, Y, Z)
  Navigation navigation = Navigation::archetype;  // that of the settings
  // Wishes of commands to the viewport, which clears them once it has followed.
  std::optional<CameraView> wanted_view;
  bool wanted_frame = false;  // frame the selected box, or the shape where none is selected
  bool cancel_drag = false;   // Esc was pressed
  bool wanted_name = false;   // the part panel gives the keyboard to the field of the name

  ShownShapes shown;
  GridState grid;
  ClustersState clusters;
  PaletteState palette;
  FileBrowserState browser;
  BottomTab bottom_tab = BottomTab::jobs;
  std::optional<BottomTab> wanted_bottom_tab;
  std::vector<Suggestion> suggestions;  // to choose from
  std::size_t chosen_suggestion = 0;
  bool show_suggestions = false;
  LearningChoice learning;
  PlotsState plots;
  MapState map;
  StripChoice strip;
  std::optional<TemplateLook> look;  // nothing: the active template of the document is shown
  bool help = false;                 // the list of keys
  KeyChange key_change;              // in that list
  bool about = false;                // with the credits
  Closing closing;
  std::string status;               // the line at the bottom: what was done last
  std::uint64_t told_revision = 0;  // the committed revision of the history that it has told of
  std::string told_status;          // and what it said then
  std::uint64_t listed_revision =
      0;  // the committed one whose step the list of the history brought into sight
};

}  // namespace archetype
