#include "core/report/plot_catalog.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/error.h"
#include "core/report/plot_makers.h"

namespace archetype {
namespace {

constexpr const char* fits = "Fits";
constexpr const char* learning = "Learning";
constexpr const char* accuracy = "Segmentation";
constexpr const char* correspondence = "Correspondence";

constexpr std::array entries{
    PlotEntry{"members", "Shapes by template", fits, PlotNeed::fits, false, false, plot_members},
    PlotEntry{"energies", "Energies by template", fits, PlotNeed::fits, false, false, plot_energies},
    PlotEntry{"energy-terms", "Terms of the energy", fits, PlotNeed::fits, false, false, plot_energy_terms},
    PlotEntry{"part-presence", "Shapes that have each part", fits, PlotNeed::fits, true, false,
              plot_part_presence},
    PlotEntry{"part-parameters", "Positions and sizes of a part", fits, PlotNeed::fits, true, true,
              plot_part_parameters},
    PlotEntry{"learning-energy", "Energy over rounds", learning, PlotNeed::learning, false, false,
              plot_learning_energy},
    PlotEntry{"learning-templates", "Templates over rounds", learning, PlotNeed::learning, false, false,
              plot_learning_templates},
    PlotEntry{"learning-sizes", "Growth with the collection", learning, PlotNeed::subsets, false, false,
              plot_learning_sizes},
    PlotEntry{"learning-starts", "Learning from several starts", learning, PlotNeed::starts, false, false,
              plot_learning_starts},
    PlotEntry{"accuracy-by-label", "Accuracy by label", accuracy, PlotNeed::labels, false, false,
              plot_accuracy_by_label},
    PlotEntry{"accuracy-by-part", "Accuracy by part", accuracy, PlotNeed::labels, false, false,
              plot_accuracy_by_part},
    PlotEntry{"accuracy-by-shape", "Accuracy by shape", accuracy, PlotNeed::labels, false, false,
              plot_accuracy_by_shape},
    PlotEntry{"confusion", "Confusion between parts", accuracy, PlotNeed::labels, false, false,
              plot_confusion},
    PlotEntry{"correspondence", "Correspondence curves", correspondence, PlotNeed::landmarks, false, false,
              plot_correspondence},
    PlotEntry{"correspondence-by-landmark", "Correspondence by landmark", correspondence, PlotNeed::landmarks,
              false, false, plot_correspondence_by_landmark},
};

}  // namespace

std::span<const PlotEntry> plot_catalog() {
  return entries;
}

const PlotEntry* find_plot(std::string_view name) {
  const auto found =
      std::ranges::find_if(entries, [&](const PlotEntry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

bool has_what_it_needs(const PlotEntry& entry, const PlotSources& sources) {
  switch (entry.need) {
    case PlotNeed::fits: {
      if (!sources.fits || sources.fits->rows.empty()) return false;
      if (!entry.of_template) return true;
      if (sources.part_template >= sources.fits->templates.size()) return false;
      const auto& parts = sources.fits->templates[sources.part_template].part_template.parts;
      return !parts.empty() && (!entry.of_part || sources.part < parts.size());
    }
    case PlotNeed::learning:
      return sources.learning && !sources.learning->steps.empty();
    case PlotNeed::labels:
      return sources.labelling && !sources.labelling->report.shapes.empty();
    case PlotNeed::landmarks:
      return sources.landmarks && sources.landmarks->all.by_diameter.count() > 0;
    case PlotNeed::subsets:
      return !sources.subsets.empty();
    case PlotNeed::starts:
      return !sources.starts.empty();
  }
  return false;
}

Figure make_figure(const PlotEntry& entry, const PlotSources& sources) {
  if (!has_what_it_needs(entry, sources))
    throw PreconditionError(std::string(entry.name) + ": what the plot is made of is missing");
  Figure figure = entry.make(sources);
  figure.name = entry.name;
  if (figure.title.empty()) figure.title = entry.title;
  return figure;
}

}  // namespace archetype
