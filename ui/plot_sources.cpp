#include "ui/plot_sources.h"

#include <imgui.h>

#include <algorithm>
#include <bit>

#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

const Evaluations& evaluations_of(Studio& studio) {
  Evaluations& evaluations = studio.ui.plots.evaluations;
  if (evaluations.project != studio.collection.path) {
    evaluations = {};
    evaluations.project = studio.collection.path;
  }
  return evaluations;
}

bool needs_fits(const PlotEntry& entry) {
  return entry.need == PlotNeed::fits || entry.need == PlotNeed::labels || entry.need == PlotNeed::landmarks;
}

FigureKey key_of(Studio& studio) {
  const PlotEntry& entry = chosen_plot(studio);
  const Evaluations& evaluations = evaluations_of(studio);
  FigureKey key;
  key.plot = entry.name;
  if (needs_fits(entry)) key.fits = use_fit_table(studio);
  if (entry.need == PlotNeed::learning) key.learning = studio.collection.content.learning;
  if (entry.need == PlotNeed::labels) key.labelling = evaluations.labelling;
  if (entry.need == PlotNeed::landmarks) key.landmarks = evaluations.landmarks;
  if (entry.need == PlotNeed::subsets) key.subsets = studio.collection.content.subsets;
  if (entry.need == PlotNeed::starts) key.starts = studio.collection.content.starts;
  if (key.fits && entry.of_template) key.part_template = template_in_focus(studio, *key.fits).value_or(0);
  if (key.fits && entry.of_part) key.part = part_in_focus(studio, *key.fits, key.part_template);
  return key;
}

PlotSources sources_of(const FigureKey& key) {
  return {key.fits.get(),      key.learning.get(),
          key.labelling.get(), key.landmarks.get(),
          key.subsets,         key.starts ? std::span(*key.starts) : std::span<const StartMeasure>(),
          key.part_template,   key.part};
}

// The stamp of the fits as they are in the table.
void follow_stamp(PlotsState& plots, const std::shared_ptr<const FitTable>& table) {
  if (!table || plots.stamped == table) return;
  std::vector<FitSummary> fits;
  for (const FitTableRow& row : table->rows) fits.push_back(row.summary);
  plots.stamp = stamp_of(fits);
  plots.stamped = table;
}

}  // namespace

std::uint64_t stamp_of(std::span<const FitSummary> fits) {
  std::uint64_t stamp = 0xcbf29ce484222325ULL;
  const auto add = [&](std::uint64_t value) {
    stamp = (stamp ^ value) * 0x9e3779b97f4a7c15ULL + (stamp >> 29);
  };
  for (const FitSummary& fit : fits) {
    add(static_cast<std::uint64_t>(fit.shape));
    add(static_cast<std::uint64_t>(fit.part_template));
    add(std::bit_cast<std::uint64_t>(fit.energy.total()));
  }
  return stamp;
}

std::optional<std::size_t> template_in_focus(const Studio& studio, const FitTable& table) {
  if (const auto& part = studio.ui.selection.part)
    for (std::size_t t = 0; t < table.templates.size(); ++t)
      if (table.templates[t].id == part->part_template) return t;
  std::vector<std::size_t> members(table.templates.size());
  for (const FitTableRow& row : table.rows) ++members[row.part_template];
  const auto most = std::ranges::max_element(members);
  if (most == members.end()) return std::nullopt;
  return static_cast<std::size_t>(most - members.begin());
}

std::size_t part_in_focus(const Studio& studio, const FitTable& table, std::size_t part_template) {
  const auto& part = studio.ui.selection.part;
  const TemplateRecord& record = table.templates[part_template];
  const bool of_it =
      part && part->part_template == record.id && part->part < record.part_template.parts.size();
  return of_it ? part->part : 0;
}

void choose_template(Studio& studio, const FitTable& table, std::size_t chosen, float width) {
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##template", table.templates[chosen].part_template.name.c_str())) {
    for (std::size_t t = 0; t < table.templates.size(); ++t) {
      ImGui::PushID(static_cast<int>(t));
      if (ImGui::Selectable(table.templates[t].part_template.name.c_str(), t == chosen))
        studio.ui.selection.part = PartOfTemplate{table.templates[t].id, 0};
      mark_target(studio, "focus:template:" + std::to_string(t));
      ImGui::PopID();
    }
    ImGui::EndCombo();
  } else {
    mark_target(studio, "focus:template");
    tooltip("Which template this is about.");
  }
}

void choose_part(Studio& studio, const FitTable& table, std::size_t part_template, float width) {
  const TemplateRecord& record = table.templates[part_template];
  const std::vector<TemplatePart>& parts = record.part_template.parts;
  if (parts.empty()) return;
  const std::size_t chosen = part_in_focus(studio, table, part_template);
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##part", parts[chosen].name.c_str())) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      ImGui::PushID(static_cast<int>(p));
      if (ImGui::Selectable(parts[p].name.c_str(), p == chosen))
        studio.ui.selection.part = PartOfTemplate{record.id, p};
      mark_target(studio, "focus:part:" + std::to_string(p));
      ImGui::PopID();
    }
    ImGui::EndCombo();
  } else {
    mark_target(studio, "focus:part");
    tooltip("Which of its parts.");
  }
}

const PlotEntry& chosen_plot(const Studio& studio) {
  const PlotEntry* entry = find_plot(studio.ui.plots.chosen);
  return entry ? *entry : plot_catalog().front();
}

std::shared_ptr<const Figure> use_figure(Studio& studio) {
  PlotsState& plots = studio.ui.plots;
  FigureKey key = key_of(studio);
  follow_stamp(plots, key.fits);
  // What the fits are read for, where it is only the stamp, changes no figure.
  const PlotEntry& entry = chosen_plot(studio);
  if (entry.need != PlotNeed::fits) key.fits.reset();
  if (key == plots.key && (plots.figure || !has_what_it_needs(entry, sources_of(key)))) return plots.figure;
  plots.key = std::move(key);
  const PlotSources sources = sources_of(plots.key);
  plots.figure = has_what_it_needs(entry, sources)
                     ? std::make_shared<const Figure>(make_figure(entry, sources))
                     : nullptr;
  return plots.figure;
}

bool evaluated_before(const Studio& studio) {
  const PlotsState& plots = studio.ui.plots;
  if (!plots.stamped) return false;
  const PlotNeed need = chosen_plot(studio).need;
  if (need == PlotNeed::labels)
    return plots.evaluations.labelling && plots.evaluations.labelling_of != plots.stamp;
  return need == PlotNeed::landmarks && plots.evaluations.landmarks &&
         plots.evaluations.landmarks_of != plots.stamp;
}

}  // namespace archetype
