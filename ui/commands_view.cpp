// The menu View: what is drawn, from where, and the look of the window.
#include <algorithm>

#include "core/base/error.h"
#include "ui/clusters_view.h"
#include "ui/command_groups.h"
#include "ui/studio.h"

namespace archetype {
namespace {

template <bool ViewOptions::*option>
void toggle(Studio& studio, Arguments) {
  studio.ui.view.*option = !(studio.ui.view.*option);
}

template <bool ViewOptions::*option>
bool is_on(const Studio& studio) {
  return studio.ui.view.*option;
}

void toggle_colour(Studio& studio, Arguments) {
  SurfaceColour& colour = studio.ui.view.colour;
  colour = colour == SurfaceColour::part ? SurfaceColour::plain : SurfaceColour::part;
}

void toggle_heat(Studio& studio, Arguments) {
  SurfaceColour& colour = studio.ui.view.colour;
  colour = colour == SurfaceColour::cost ? SurfaceColour::part : SurfaceColour::cost;
}

bool colour_is_part(const Studio& studio) {
  return studio.ui.view.colour == SurfaceColour::part;
}

template <CameraView view>
void look(Studio& studio, Arguments) {
  studio.ui.wanted_view = view;
}

void frame_selection(Studio& studio, Arguments) {
  studio.ui.wanted_frame = true;
}

// G, S and R take the tool, and begin at once where something is selected.
template <BoxTool tool>
void transform_command(Studio& studio, Arguments) {
  studio.ui.tool = tool;
  begin_transform(studio, tool);
}

// The rows of clusters and the plots have no camera; a wish made there would wait for the next view.
std::string needs_camera(const Studio& studio) {
  const bool flat = studio.ui.centre == CentreView::clusters || studio.ui.centre == CentreView::plots;
  return flat ? "go to a view with a camera first, like Shape" : "";
}

std::string needs_no_handle(const Studio& studio) {
  return studio.viewport.drag || (studio.history.has_preview() && !studio.ui.transform)
             ? "let go of what you drag first"
             : "";
}

void toggle_snapping(Studio& studio, Arguments) {
  studio.ui.snapping = !studio.ui.snapping;
}

template <BoxTool tool>
void take_tool(Studio& studio, Arguments) {
  studio.ui.tool = tool;
}

template <BoxTool tool>
bool has_tool(const Studio& studio) {
  return studio.ui.tool == tool;
}

// Pressed again, the key lets the drag go free.
template <int axis>
void keep_to_axis(Studio& studio, Arguments) {
  std::optional<int>& kept = studio.ui.transform ? studio.ui.transform->axis : studio.ui.drag_axis;
  kept = kept == axis ? std::nullopt : std::optional(axis);
}

std::string needs_handle(const Studio& studio) {
  return studio.viewport.drag || studio.ui.transform ? "" : "press G, S or R or drag a handle first";
}

void set_theme(Studio& studio, const char* theme) {
  studio.settings.theme = theme;
  studio.wanted_fonts = true;
}

void toggle_bottom(Studio& studio, Arguments) {
  studio.settings.show_bottom = !studio.settings.show_bottom;
}

template <BottomTab tab>
void show_tab(Studio& studio, Arguments) {
  studio.settings.show_bottom = true;
  studio.ui.wanted_bottom_tab = tab;
}

template <int percent>
void scale_by(Studio& studio, Arguments) {
  studio.settings.ui_scale = std::clamp(studio.fonts.scale * percent / 100.0, 0.5, 4.0);
  studio.wanted_fonts = true;
}

void scale_of_screen(Studio& studio, Arguments) {
  studio.settings.ui_scale = 0;
  studio.wanted_fonts = true;
}

void set_command(Studio& studio, Arguments arguments) {
  if (arguments.size() != 2) throw Error("expected a setting and its value");
  if (const std::string problem = set_setting(studio.settings, arguments[0], arguments[1]); !problem.empty())
    throw Error(problem);
  studio.wanted_fonts = true;
}

// The rows as the grid shows them, so that the arrow keys follow its order and its filter.
void step_shape(Studio& studio, int step) {
  if (studio.ui.centre == CentreView::clusters) {
    step_in_clusters(studio, step > 0 ? CellStep::right : CellStep::left, false);
    return;
  }
  const auto& rows = studio.collection.rows();
  const std::vector<std::size_t>& visible = shown_rows(studio);
  if (visible.empty()) return;
  const auto at = std::find_if(visible.begin(), visible.end(),
                               [&](std::size_t row) { return rows[row].id == studio.ui.shape; });
  const auto last = static_cast<std::ptrdiff_t>(visible.size()) - 1;
  const std::ptrdiff_t next =
      at == visible.end() ? 0 : std::clamp<std::ptrdiff_t>(at - visible.begin() + step, 0, last);
  const ShapeId shape = rows[visible[static_cast<std::size_t>(next)]].id;
  select_only(studio.ui.selection, {shape});
  show_shape(studio, shape);
  studio.ui.grid.scroll_to_shape = true;
}

template <int step>
void step_command(Studio& studio, Arguments) {
  step_shape(studio, step);
}

void select_shape(Studio& studio, Arguments arguments) {
  const std::string name = text_argument(arguments, 0, "the name of a shape");
  for (const ShapeRow& row : studio.collection.rows()) {
    if (row.name != name) continue;
    show_shape(studio, row.id);
    studio.ui.grid.scroll_to_shape = true;
    return;
  }
  throw Error("the collection has no shape \"" + name + "\"");
}

}  // namespace

void add_view_commands(std::vector<Command>& commands) {
  commands.insert(
      commands.end(),
      {
          {.name = "surface",
           .title = "Surface",
           .menu = "View",
           .run = toggle<&ViewOptions::surface>,
           .checked = is_on<&ViewOptions::surface>},
          {.name = "wireframe",
           .title = "Wireframe",
           .menu = "View",
           .key = "W",
           .run = toggle<&ViewOptions::wireframe>,
           .checked = is_on<&ViewOptions::wireframe>},
          {.name = "points",
           .title = "Sample points",
           .menu = "View",
           .key = "P",
           .run = toggle<&ViewOptions::points>,
           .checked = is_on<&ViewOptions::points>},
          {.name = "part-colours",
           .title = "Colour by part",
           .menu = "View",
           .key = "C",
           .run = toggle_colour,
           .checked = colour_is_part},
          {.name = "heat-map",
           .title = "Colour by how badly points are explained",
           .menu = "View",
           .key = "H",
           .run = toggle_heat,
           .checked = [](const Studio& s) { return s.ui.view.colour == SurfaceColour::cost; }},
          {.name = "boxes",
           .title = "Template boxes",
           .menu = "View",
           .key = "B",
           .run = toggle<&ViewOptions::mean_boxes>,
           .checked = is_on<&ViewOptions::mean_boxes>},
          {.name = "fitted-boxes",
           .title = "Fitted boxes",
           .menu = "View",
           .key = "Shift+B",
           .run = toggle<&ViewOptions::fitted_boxes>,
           .checked = is_on<&ViewOptions::fitted_boxes>},
          {.name = "average",
           .title = "Average of the collection",
           .menu = "View",
           .key = "O",
           .run = toggle<&ViewOptions::average>,
           .why_not = needs_collection,
           .checked = is_on<&ViewOptions::average>},
          {.name = "spread",
           .title = "Spread of the parts",
           .menu = "View",
           .key = "E",
           .run = toggle<&ViewOptions::spread>,
           .checked = is_on<&ViewOptions::spread>},
          {.name = "part-names",
           .title = "Names of parts",
           .menu = "View",
           .key = "N",
           .run = toggle<&ViewOptions::part_names>,
           .checked = is_on<&ViewOptions::part_names>},
          {.name = "ground",
           .title = "Ground",
           .menu = "View",
           .run = toggle<&ViewOptions::ground>,
           .checked = is_on<&ViewOptions::ground>},
          {.name = "orthographic",
           .title = "Orthographic",
           .menu = "View",
           .key = "5",
           .run = toggle<&ViewOptions::orthographic>,
           .checked = is_on<&ViewOptions::orthographic>,
           .separator = true},
          {.name = "four-views",
           .title = "Perspective, top, front and right",
           .menu = "View",
           .key = "4",
           .run = toggle<&ViewOptions::four_views>,
           .checked = is_on<&ViewOptions::four_views>},
          {.name = "view-front",
           .title = "From the front",
           .menu = "View",
           .key = "1",
           .run = look<CameraView::front>,
           .why_not = needs_camera},
          {.name = "view-back",
           .title = "From the back",
           .menu = "View",
           .key = "Ctrl+1",
           .run = look<CameraView::back>,
           .why_not = needs_camera},
          {.name = "view-right",
           .title = "From the right",
           .menu = "View",
           .key = "3",
           .run = look<CameraView::right>,
           .why_not = needs_camera},
          {.name = "view-left",
           .title = "From the left",
           .menu = "View",
           .key = "Ctrl+3",
           .run = look<CameraView::left>,
           .why_not = needs_camera},
          {.name = "view-top",
           .title = "From above",
           .menu = "View",
           .key = "7",
           .run = look<CameraView::top>,
           .why_not = needs_camera},
          {.name = "view-bottom",
           .title = "From below",
           .menu = "View",
           .key = "Ctrl+7",
           .run = look<CameraView::bottom>,
           .why_not = needs_camera},
          {.name = "view-home",
           .title = "Home",
           .menu = "View",
           .key = "Home",
           .run = look<CameraView::home>,
           .why_not = needs_camera},
          {.name = "frame",
           .title = "Frame the selection",
           .menu = "View",
           .key = "F",
           .run = frame_selection,
           .why_not = needs_camera},
          {.name = "tool-move",
           .title = "Move boxes",
           .menu = "Part",
           .run = take_tool<BoxTool::move>,
           .checked = has_tool<BoxTool::move>,
           .separator = true},
          {.name = "tool-scale",
           .title = "Scale boxes",
           .menu = "Part",
           .run = take_tool<BoxTool::scale>,
           .checked = has_tool<BoxTool::scale>},
          {.name = "tool-rotate",
           .title = "Rotate boxes",
           .menu = "Part",
           .run = take_tool<BoxTool::rotate>,
           .checked = has_tool<BoxTool::rotate>},
          {.name = "grab",
           .title = "Move with the mouse or by numbers",
           .menu = "Part",
           .key = "G",
           .run = transform_command<BoxTool::move>,
           .why_not = needs_no_handle},
          {.name = "scale",
           .title = "Scale with the mouse or by numbers",
           .menu = "Part",
           .key = "S",
           .run = transform_command<BoxTool::scale>,
           .why_not = needs_no_handle},
          {.name = "rotate",
           .title = "Rotate with the mouse or by numbers",
           .menu = "Part",
           .key = "R",
           .run = transform_command<BoxTool::rotate>,
           .why_not = needs_no_handle},
          {.name = "snapping",
           .title = "Snap dragged boxes",
           .menu = "Part",
           .key = "Shift+S",
           .run = toggle_snapping,
           .checked = [](const Studio& s) { return s.ui.snapping; }},
          {.name = "axis-x",
           .title = "Keep the drag to the x axis",
           .menu = "Part",
           .key = "X",
           .run = keep_to_axis<0>,
           .why_not = needs_handle},
          {.name = "axis-y",
           .title = "Keep the drag to the y axis",
           .menu = "Part",
           .key = "Y",
           .run = keep_to_axis<1>,
           .why_not = needs_handle},
          {.name = "axis-z",
           .title = "Keep the drag to the z axis",
           .menu = "Part",
           .key = "Z",
           .run = keep_to_axis<2>,
           .why_not = needs_handle},
          {.name = "next-shape",
           .title = "Next shape",
           .menu = "Shape",
           .key = "Right",
           .run = step_command<1>,
           .why_not = needs_collection},
          {.name = "previous-shape",
           .title = "Previous shape",
           .menu = "Shape",
           .key = "Left",
           .run = step_command<-1>,
           .why_not = needs_collection},
          {.name = "select-shape",
           .title = "Show a shape",
           .arguments = "NAME",
           .run = select_shape,
           .why_not = needs_collection},
          {.name = "bottom-panel",
           .title = "Jobs and messages",
           .menu = "Window",
           .key = "Ctrl+J",
           .run = toggle_bottom,
           .checked = [](const Studio& s) { return s.settings.show_bottom; }},
          {.name = "show-jobs", .title = "Show jobs", .menu = "Window", .run = show_tab<BottomTab::jobs>},
          {.name = "show-messages",
           .title = "Show messages",
           .menu = "Window",
           .run = show_tab<BottomTab::messages>},
          {.name = "show-history",
           .title = "Show history",
           .menu = "Window",
           .run = show_tab<BottomTab::history>},
          {.name = "show-diagnostics",
           .title = "Show diagnostics",
           .menu = "Window",
           .run = show_tab<BottomTab::diagnostics>},
          {.name = "theme-dark",
           .title = "Dark theme",
           .menu = "Window",
           .run = [](Studio& s, Arguments) { set_theme(s, "dark"); },
           .checked = [](const Studio& s) { return s.theme == Theme::dark; },
           .separator = true},
          {.name = "theme-light",
           .title = "Light theme",
           .menu = "Window",
           .run = [](Studio& s, Arguments) { set_theme(s, "light"); },
           .checked = [](const Studio& s) { return s.theme == Theme::light; }},
          {.name = "larger", .title = "Larger text", .menu = "Window", .key = "Ctrl++", .run = scale_by<110>},
          {.name = "smaller",
           .title = "Smaller text",
           .menu = "Window",
           .key = "Ctrl+-",
           .run = scale_by<91>},
          {.name = "scale-of-screen",
           .title = "Text size of the screen",
           .menu = "Window",
           .key = "Ctrl+0",
           .run = scale_of_screen},
          {.name = "set", .title = "Change a setting", .arguments = "NAME VALUE", .run = set_command},
      });
}

}  // namespace archetype
