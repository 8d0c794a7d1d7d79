// Learning, round by round (section 4.2): the energy, how the shapes move between templates, who spawned
// whom; a click on a template looks at it in the viewport. Shows what the project holds, so also a learning
// that was stopped or done before the program was started.
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "ui/energy_plot.h"
#include "ui/flow_chart.h"
#include "ui/icons.h"
#include "ui/job_row.h"
#include "ui/learning_actions.h"
#include "ui/panels.h"
#include "ui/studio.h"
#include "ui/template_picture.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

std::string summary(const LearningRecord& record, const Studio& studio) {
  std::string text = record.start.front().name;
  if (record.start.size() > 1) text += " and " + plural(record.start.size() - 1, "more template");
  text += ": ";
  if (record.steps.empty()) return text + "no round is whole yet";
  text += plural(record.steps.size(), "round") + (record.settled ? ", settled" : ", not settled yet");
  text += "  ·  energy " + number(record.steps.front().energy_before) + " to " +
          number(record.steps.back().energy);
  text += "  ·  " + plural(record.steps.back().templates.size(), "template");
  return text + "  ·  judged by " + std::to_string(record.judging.size()) + " of " +
         plural(studio.collection.rows().size(), "shape");
}

void draw_head(Studio& studio, const std::optional<JobView>& job, const LearningRecord* record) {
  if (job) {
    const std::optional<double> seconds = most_seconds_of_rounds(studio);
    draw_active_job(studio, *job, seconds ? "  ·  rounds: at most " + duration_text(*seconds) + " more" : "");
    return;
  }
  const float button = 110 * studio.fonts.scale;
  const bool can = studio.history.current().active_template() != nullptr;
  const std::string begins = can ? "Learning " + what_learning_begins_with(studio) + "." : "";
  ImGui::AlignTextToFramePadding();
  const float room = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
  const float left = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(fitted(summary(*record, studio), room).c_str());
  ImGui::SameLine(left + room + ImGui::GetStyle().ItemSpacing.x);
  command_button(studio, "learn",
                 std::string(icon::play) + (can && learning_goes_on(studio) ? "  Go on" : "  Learn"),
                 {button, 0});
  if (!begins.empty()) muted_text(studio, fitted(begins, left + room + button - ImGui::GetCursorPosX()));
  if (!begins.empty()) tooltip(begins.c_str());
}

std::vector<PlottedRound> plotted(const LearningRecord& record, const std::vector<FlowColumn>& columns) {
  std::vector<PlottedRound> rounds;
  if (record.steps.empty()) return rounds;
  rounds.push_back({record.steps.front().energy_before, plural(record.start.size(), "template")});
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const LearningStep& step = record.steps[i];
    rounds.push_back({step.energy, plural(step.templates.size(), "template") + ", " +
                                       plural(columns[i + 1].moved, "shape") + " moved"});
  }
  return rounds;
}

void draw_plot(Studio& studio, const LearningRecord& record, const std::vector<FlowColumn>& columns,
               ImVec2 size) {
  ImGui::BeginChild("##plot", size);
  muted_text(studio, "Energy by round");
  tooltip(
      "The mean energy of the judging shapes with the template that fits each best, and what the templates "
      "cost.");
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (record.steps.empty()) {
    muted_paragraph(studio, "The first value comes with the first whole round.");
  } else if (const auto round =
                 draw_energy_plot(studio, plotted(record, columns), studio.ui.learning.round, room)) {
    studio.ui.learning = {round, std::nullopt};
  }
  ImGui::EndChild();
}

const ShapeRow* row_of(const Studio& studio, ShapeId id) {
  const std::optional<std::size_t> row = find_row(studio.collection, id);
  return row ? &studio.collection.rows()[*row] : nullptr;
}

// A shape as a line that brings it into view. `note` stands muted at its right.
void draw_shape_line(Studio& studio, ShapeId id, const std::string& note, ImU32 colour) {
  const ShapeRow* row = row_of(studio, id);
  if (!row) return;
  ImGui::PushID(static_cast<int>(id));
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float line = ImGui::GetTextLineHeight();
  const float scale = studio.fonts.scale;
  if (ImGui::Selectable("##shape", studio.ui.shape == id)) {
    show_shape(studio, id);
    studio.ui.grid.scroll_to_shape = true;
  }
  mark_target(studio, "member:" + row->name);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({low.x + 2 * scale, low.y + line * 0.2f},
                     {low.x + 2 * scale + line * 0.6f, low.y + line * 0.8f}, colour, 2 * scale);
  const float at = low.x + line + 4 * scale;
  const std::string shown_note = fitted(note, width * 0.6f);
  const float note_width = ImGui::CalcTextSize(shown_note.c_str()).x;
  draw.AddText({at, low.y}, ImGui::GetColorU32(ImGuiCol_Text),
               fitted(row->name, low.x + width - note_width - at - 10 * scale).c_str());
  draw.AddText({low.x + width - note_width - 4 * scale, low.y}, ImGui::GetColorU32(colours(studio).muted),
               shown_note.c_str());
  ImGui::PopID();
}

void draw_moved(Studio& studio, const LearningRecord& record, const std::vector<FlowColumn>& columns,
                std::size_t c) {
  const FlowColumn& column = columns[c];
  if (c == 0) {
    muted_paragraph(studio,
                    "What learning began with. Click a template to look at its boxes on the shape in view.");
    return;
  }
  const std::string title = plural(column.moved, "shape") + " moved in " + round_name(c);
  ImGui::TextUnformatted(title.c_str());
  for (const FlowEnd& end : column.ended) {
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(end_text(columns[c - 1], column, end).c_str());
    ImGui::PopTextWrapPos();
  }
  if (column.moved == 0) muted_paragraph(studio, "Click a template to see its members and its boxes.");
  for (const FlowBand& band : column.bands) {
    if (!band.moved) continue;
    const FlowNode& from = columns[c - 1].nodes[band.from];
    const FlowNode& to = column.nodes[band.to];
    for (const std::size_t shape : band.shapes)
      draw_shape_line(studio, record.judging[shape],
                      from.part_template->name + " to " + to.part_template->name, line_colour(to.line));
  }
}

std::string came_of(const LearningRecord& record, const std::vector<FlowColumn>& columns, std::size_t c,
                    const FlowNode& node) {
  const LearningLine& line = record.lines[node.line];
  if (!line.parent) return c == 0 ? "learning began with it" : "from the start";
  const auto born = static_cast<std::size_t>(std::max(line.born, 1));
  if (born < columns.size())
    for (const FlowNode& parent : columns[born - 1].nodes)
      if (parent.line == *line.parent)
        return "spawned by " + parent.part_template->name + ", " + round_name(born);
  return "spawned in " + round_name(born);
}

void draw_chosen(Studio& studio, const LearningRecord& record, const std::vector<FlowColumn>& columns,
                 std::size_t c, std::size_t n) {
  const FlowNode& node = columns[c].nodes[n];
  const float side = 5.2f * ImGui::GetTextLineHeight();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  draw_template_picture(*ImGui::GetWindowDrawList(), *node.part_template, low, side);
  ImGui::Dummy({side, side});
  ImGui::SameLine();
  ImGui::BeginGroup();
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(studio.fonts.bold);
  ImGui::TextUnformatted(fitted(node.part_template->name, room).c_str());
  ImGui::PopFont();
  muted_text(studio, fitted(came_of(record, columns, c, node), room));
  muted_text(studio, fitted(plural(node.part_template->parts.size(), "part") + ", " +
                                plural(node.members.size(), "member") + " after " + round_name(c),
                            room));
  const bool looked_at = studio.ui.look && *studio.ui.look->part_template == *node.part_template;
  if (looked_at) {
    command_button(studio, "take-look", "Take", {share_of_width(2), 0});
    ImGui::SameLine();
    command_button(studio, "stop-looking", "Back", {share_of_width(1), 0});
  } else {
    if (ImGui::Button("Look at it", {share_of_width(1), 0})) look_into_round(studio, c, n);
    mark_target(studio, "learning:look");
  }
  ImGui::EndGroup();
  ImGui::BeginChild("##members");
  for (const std::size_t shape : node.members) {
    std::string note;
    for (const FlowBand& band : columns[c].bands) {
      if (band.moved && band.to == n && std::ranges::binary_search(band.shapes, shape))
        note = "from " + columns[c - 1].nodes[band.from].part_template->name;
    }
    draw_shape_line(studio, record.judging[shape], note, line_colour(node.line));
  }
  ImGui::EndChild();
}

// The newest round where none is chosen; what is gone, by learning anew, is chosen no more.
void keep_choice_valid(LearningChoice& choice, const std::vector<FlowColumn>& columns) {
  if (choice.round && *choice.round >= columns.size()) choice = {};
  if (choice.part_template && (!choice.round || *choice.part_template >= columns[*choice.round].nodes.size()))
    choice.part_template.reset();
}

void draw_details(Studio& studio, const LearningRecord& record, const std::vector<FlowColumn>& columns) {
  ImGui::BeginChild("##details");
  const LearningChoice choice = studio.ui.learning;
  const std::size_t round = choice.round.value_or(columns.size() - 1);
  if (choice.part_template)
    draw_chosen(studio, record, columns, round, *choice.part_template);
  else
    draw_moved(studio, record, columns, round);
  ImGui::EndChild();
}

}  // namespace

void draw_learning_panel(Studio& studio) {
  const std::optional<JobView> job = learning_job(studio);
  const std::shared_ptr<const LearningRecord> record = studio.collection.content.learning;
  if (!job && !record) {
    empty_hint(studio, "Nothing was learned yet",
               "Learning moves the boxes of the template to where the parts of all shapes are, and spawns "
               "templates for clusters of other shapes. Its rounds show here while it runs.");
    const float width = 200 * studio.fonts.scale;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (ImGui::GetContentRegionAvail().x - width) / 2);
    command_button(studio, "learn", std::string(icon::play) + "  Learn from all shapes", {width, 0});
    if (!studio.history.current().active_template()) return;
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string begins = fitted("It " + what_learning_begins_with(studio) + ".", room);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (room - ImGui::CalcTextSize(begins.c_str()).x) / 2);
    muted_text(studio, begins);
    return;
  }
  draw_head(studio, job, record.get());
  if (!record) return;
  const std::vector<FlowColumn> columns = learning_flow(*record);
  keep_choice_valid(studio.ui.learning, columns);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float plot = std::clamp(room.x * 0.24f, 180 * studio.fonts.scale, 320 * studio.fonts.scale);
  const float details = std::clamp(room.x * 0.26f, 200 * studio.fonts.scale, 340 * studio.fonts.scale);
  const float height = std::max(room.y, 120 * studio.fonts.scale);
  ImGui::BeginChild("##rounds", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
  draw_plot(studio, *record, columns, {plot, height});
  ImGui::SameLine();
  const float flow = std::max(room.x - plot - details - 2 * gap, 160 * studio.fonts.scale);
  const bool coming = job && !record->settled;
  const auto clicked = draw_flow_chart(studio, columns, *record, studio.ui.learning, coming, {flow, height});
  studio.ui.learning.bring_into_sight = false;
  if (clicked) {
    studio.ui.learning = *clicked;
    if (clicked->part_template) look_into_round(studio, *clicked->round, *clicked->part_template);
  }
  ImGui::SameLine();
  ImGui::BeginChild("##right", {details, height});
  draw_details(studio, *record, columns);
  ImGui::EndChild();
  ImGui::EndChild();
}

}  // namespace archetype
