// The centre view of plots: a list on the left, the chosen one on the right.
#include <imgui.h>

#include <cstring>

#include "ui/icons.h"
#include "ui/panels.h"
#include "ui/plot_sources.h"
#include "ui/plot_view.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

void draw_list(Studio& studio) {
  const char* group = "";
  for (const PlotEntry& entry : plot_catalog()) {
    if (std::strcmp(group, entry.group) != 0) {
      section_title(studio, entry.group);
      group = entry.group;
    }
    const bool chosen = &entry == &chosen_plot(studio);
    if (ImGui::Selectable(entry.title, chosen)) studio.settings.plot = studio.ui.plots.chosen = entry.name;
    mark_target(studio, std::string("plot:") + entry.name);
    if (ImGui::CalcTextSize(entry.title).x > ImGui::GetItemRectSize().x) tooltip(entry.title);
  }
}

// What to do first, with the button that does it.
struct Missing {
  const char* title;
  const char* hint;
  const char* command;
  const char* label;
};

Missing missing(const Studio& studio, const PlotEntry& entry) {
  if (!studio.collection.open())
    return {"No collection is open", "Plots tell of the shapes of a project.", "open-folder", "Open folder…"};
  switch (entry.need) {
    case PlotNeed::fits:
      break;
    case PlotNeed::learning:
      return {"Nothing was learned yet", "This plot shows learning, round by round.", "learn",
              "Learn from all shapes"};
    case PlotNeed::labels:
      return {
          "Not compared with true labels yet",
          "A folder with one file per shape, SHAPE.seg (a number per face) or SHAPE_labels.txt, says which "
          "label each face truly has. The project remembers the folder.",
          "evaluate-labels", "Choose the folder…"};
    case PlotNeed::landmarks:
      return {
          "Not compared with landmarks yet",
          "A folder with one file per shape, SHAPE.vts (x y z a line), says where the same points lie on all "
          "of them. The project remembers the folder.",
          "evaluate-landmarks", "Choose the folder…"};
    case PlotNeed::subsets:
      return {
          "Not measured yet",
          "Learns anew from 8, 16, 32 … of the shapes, beside your work; the project stays as it is. Where "
          "true labels or landmarks are known, a quarter of the shapes is kept apart to judge by. It takes "
          "as long as several learnings, and can be paused and stopped.",
          "measure-sizes", "Measure"};
    case PlotNeed::starts:
      return {
          "Not measured yet",
          "Learns from each of the six best templates that are suggested for the shapes, beside your work, "
          "and shows how alike the results are; the project stays as it is. It takes as long as several "
          "learnings, and can be paused and stopped.",
          "measure-starts", "Measure"};
  }
  return {"No shape is fitted yet", "Fit a template to all shapes, or learn from them.", "fit-all",
          "Fit all shapes"};
}

const std::filesystem::path& known_folder(const Studio& studio, PlotNeed need) {
  const GroundTruthFolders& truth = studio.collection.content.truth;
  return need == PlotNeed::landmarks ? truth.landmarks : truth.labels;
}

void draw_missing(Studio& studio) {
  const PlotEntry& entry = chosen_plot(studio);
  const Missing what = missing(studio, entry);
  empty_hint(studio, what.title, what.hint);
  const float width = std::min(ImGui::GetContentRegionAvail().x, 300 * studio.fonts.scale);
  const float indent = (ImGui::GetContentRegionAvail().x - width) / 2;
  const bool truth = entry.need == PlotNeed::labels || entry.need == PlotNeed::landmarks;
  if (truth && studio.collection.open() && !known_folder(studio, entry.need).empty()) {
    const std::filesystem::path folder = known_folder(studio, entry.need);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
    const std::string name = folder.parent_path().filename().string() + "/" + folder.filename().string();
    if (ImGui::Button(fitted("Compare with " + name, width - 10 * studio.fonts.scale).c_str(), {width, 0})) {
      const std::string arguments[] = {folder.string()};
      run_command(studio, what.command, arguments);
    }
    mark_target(studio, "plots:known-folder");
    tooltip(folder.c_str());
  }
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  command_button(studio, what.command, what.label, {width, 0});
}

}  // namespace

void draw_plots_tools(Studio& studio) {
  command_button(studio, "save-plot-svg", std::string(icon::save) + " SVG");
  ImGui::SameLine();
  command_button(studio, "save-plot-csv", std::string(icon::save) + " CSV");
  const PlotEntry& entry = chosen_plot(studio);
  const std::shared_ptr<const FitTable> table = studio.ui.plots.key.fits;
  if (entry.of_template && table && !table->templates.empty()) {
    separator_in_line(studio);
    const std::size_t chosen = template_in_focus(studio, *table).value_or(0);
    choose_template(studio, *table, chosen, 190 * studio.fonts.scale);
    if (entry.of_part) {
      ImGui::SameLine(0, 6 * studio.fonts.scale);
      choose_part(studio, *table, chosen, 170 * studio.fonts.scale);
    }
  }
  if (entry.need != PlotNeed::fits && entry.need != PlotNeed::learning) {
    separator_in_line(studio);
    if (entry.need == PlotNeed::subsets)
      command_button(studio, "measure-sizes", "Measure");
    else if (entry.need == PlotNeed::starts)
      command_button(studio, "measure-starts", "Measure");
    else if (entry.need == PlotNeed::labels)
      command_button(studio, "evaluate-labels", "True labels…");
    else
      command_button(studio, "evaluate-landmarks", "Landmarks…");
  }
}

void draw_plots_view(Studio& studio) {
  const float scale = studio.fonts.scale;
  const std::shared_ptr<const Figure> figure = use_figure(studio);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float list = std::clamp(room.x * 0.36f, 120 * scale, 260 * scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * scale, 8 * scale});
  ImGui::BeginChild("##plot-list", {list, room.y}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  draw_list(studio);
  ImGui::EndChild();
  ImGui::SameLine(0, 0);
  ImGui::BeginChild("##plot-room", {room.x - list, room.y}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  if (!figure) {
    draw_missing(studio);
  } else {
    ImGui::PushFont(studio.fonts.title);
    ImGui::TextUnformatted(fitted(figure->title, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopFont();
    if (evaluated_before(studio))
      muted_paragraph(studio,
                      "Shapes were fitted anew since this was compared: compare again for the new fits.");
    ImGui::Dummy({0, 2 * scale});
    draw_plot_view(studio, *figure, ImGui::GetContentRegionAvail());
  }
  ImGui::EndChild();
}

}  // namespace archetype
