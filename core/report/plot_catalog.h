// The plots that there are, and what each is made of.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/report/plot.h"
#include "core/session/evaluate_labelling.h"
#include "core/session/evaluate_landmarks.h"
#include "core/session/fit_table.h"
#include "core/session/learn_templates.h"
#include "core/session/measure_starts.h"
#include "core/session/measure_subsets.h"

namespace archetype {

// What a plot cannot be made without.
enum class PlotNeed { fits, learning, labels, landmarks, subsets, starts };

// Null or empty: not at hand. The plots point to none of it.
struct PlotSources {
  const FitTable* fits = nullptr;
  const LearningRecord* learning = nullptr;
  const LabellingEvaluation* labelling = nullptr;
  const LandmarkEvaluation* landmarks = nullptr;
  std::span<const SubsetMeasure> subsets = {};
  std::span<const StartMeasure> starts = {};
  // For the plots of one template, and of one of its parts: an index into the templates of the fits.
  std::size_t part_template = 0;
  std::size_t part = 0;
};

struct PlotEntry {
  const char* name;   // for scripts and files: "part-sizes"
  const char* title;  // for people
  const char* group;  // what it tells of
  PlotNeed need;
  bool of_template;  // whether it is of PlotSources::part_template
  bool of_part;
  Figure (*make)(const PlotSources&);
};

std::span<const PlotEntry> plot_catalog();
const PlotEntry* find_plot(std::string_view name);  // null: there is none

// Whether the sources have what the plot needs, with something in it.
bool has_what_it_needs(const PlotEntry& entry, const PlotSources& sources);
// With name and title of the entry. Throws PreconditionError where something is missing. A few milliseconds
// for 10,000 shapes.
Figure make_figure(const PlotEntry& entry, const PlotSources& sources);

}  // namespace archetype
