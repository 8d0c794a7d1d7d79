// The menu Points: boxes from the shape and its points.
#include "core/base/error.h"
#include "core/geometry/box_points.h"
#include "core/session/actions.h"
#include "ui/command_groups.h"
#include "ui/point_tools.h"
#include "ui/selection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

template <PointTool tool>
void tool_command(Studio& studio, Arguments) {
  take_point_tool(studio, tool);
}

template <PointTool tool>
bool has_tool(const Studio& studio) {
  return studio.ui.points.tool == tool;
}

std::string needs_samples(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  if (std::string reason = needs_shape(studio); !reason.empty()) return reason;
  return studio.shape.samples ? "" : "wait for the points of the shape";
}

std::string needs_points(const Studio& studio) {
  if (std::string reason = needs_samples(studio); !reason.empty()) return reason;
  return selected_points(studio).empty() ? "select points of the shape first, by rectangle or lasso" : "";
}

std::string needs_part_and_samples(const Studio& studio) {
  if (std::string reason = needs_part(studio); !reason.empty()) return reason;
  return needs_samples(studio);
}

void around_command(Studio& studio, Arguments) {
  const Box box = box_around(selected_points(studio), Eigen::Quaterniond::Identity());
  select_only(studio.ui, add_part(studio.history, box));
  note_made_on_shape(studio);
}

void deselect_command(Studio& studio, Arguments) {
  studio.ui.points.selected.clear();
}

// The selected points, or those that the fit gives to the part.
std::vector<Vec3> points_of(const Studio& studio, std::size_t part) {
  if (std::vector<Vec3> chosen = selected_points(studio); !chosen.empty()) return chosen;
  if (const std::string reason = needs_fit(studio); !reason.empty())
    throw Error("select points of the shape, or " + reason);
  const std::vector<Vec3> all = points_in_view(studio);
  const std::vector<std::int16_t>& labels = studio.shape.fit->fit.labels;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (labels[i] == static_cast<std::int16_t>(part)) points.push_back(all[i]);
  if (points.empty()) throw Error("no point of the shape belongs to the part; select some first");
  return points;
}

void grow_command(Studio& studio, Arguments) {
  std::vector<PlacedPart> placed = selected_boxes(studio);
  for (PlacedPart& each : placed) each.box = grown_to(each.box, points_of(studio, each.part));
  set_part_boxes(studio.history, placed);
  note_made_on_shape(studio);
}

void shrink_command(Studio& studio, Arguments) {
  const std::vector<Vec3> chosen = selected_points(studio);
  const std::vector<Vec3> points = chosen.empty() ? points_in_view(studio) : chosen;
  std::vector<PlacedPart> placed = selected_boxes(studio);
  for (PlacedPart& each : placed) each.box = shrunk_to(each.box, points);
  set_part_boxes(studio.history, placed);
  note_made_on_shape(studio);
}

}  // namespace

void add_point_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "draw-box",
                                       .title = "Draw a box on the shape",
                                       .menu = "Points",
                                       .key = "D",
                                       .run = tool_command<PointTool::draw_box>,
                                       .why_not = needs_template,
                                       .checked = has_tool<PointTool::draw_box>},
                                      {.name = "box-of-piece",
                                       .title = "Boxes around connected pieces",
                                       .menu = "Points",
                                       .key = "J",
                                       .run = tool_command<PointTool::component>,
                                       .why_not = needs_samples,
                                       .checked = has_tool<PointTool::component>},
                                      {.name = "box-of-segment",
                                       .title = "Boxes around automatic segments",
                                       .menu = "Points",
                                       .key = "A",
                                       .run = tool_command<PointTool::segment>,
                                       .why_not = needs_samples,
                                       .checked = has_tool<PointTool::segment>},
                                      {.name = "select-rectangle",
                                       .title = "Select points by a rectangle",
                                       .menu = "Points",
                                       .key = "Q",
                                       .run = tool_command<PointTool::rectangle>,
                                       .why_not = needs_samples,
                                       .checked = has_tool<PointTool::rectangle>},
                                      {.name = "select-lasso",
                                       .title = "Select points by a lasso",
                                       .menu = "Points",
                                       .key = "Shift+Q",
                                       .run = tool_command<PointTool::lasso>,
                                       .why_not = needs_samples,
                                       .checked = has_tool<PointTool::lasso>},
                                      {.name = "box-around-points",
                                       .title = "Box around the selected points",
                                       .menu = "Points",
                                       .key = "Shift+D",
                                       .run = around_command,
                                       .why_not = needs_points,
                                       .edits = true},
                                      {.name = "grow-to-points",
                                       .title = "Grow to the selected points, or those of the part",
                                       .menu = "Points",
                                       .key = "Shift+G",
                                       .run = grow_command,
                                       .why_not = needs_part_and_samples,
                                       .edits = true},
                                      {.name = "shrink-to-points",
                                       .title = "Shrink to the points inside",
                                       .menu = "Points",
                                       .key = "Shift+T",
                                       .run = shrink_command,
                                       .why_not = needs_part_and_samples,
                                       .edits = true},
                                      {.name = "deselect-points",
                                       .title = "Deselect the points",
                                       .menu = "Points",
                                       .run = deselect_command,
                                       .why_not = needs_points},
                                  });
}

}  // namespace archetype
