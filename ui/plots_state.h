// What the view of plots shows and what it is made of. Plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/report/plot_catalog.h"
#include "core/session/fit_table.h"

namespace archetype {

// Against ground truth, of one project. Null: not evaluated since it was opened.
struct Evaluations {
  std::filesystem::path project;
  std::shared_ptr<const LabellingEvaluation> labelling;
  std::shared_ptr<const LandmarkEvaluation> landmarks;
  std::uint64_t labelling_of = 0;  // stamps of the fits that they are of: see stamp_of()
  std::uint64_t landmarks_of = 0;
};

// All that a figure depends on; it is made anew when this changes.
struct FigureKey {
  std::string plot;
  std::shared_ptr<const FitTable> fits;
  std::shared_ptr<const LearningRecord> learning;
  std::shared_ptr<const LabellingEvaluation> labelling;
  std::shared_ptr<const LandmarkEvaluation> landmarks;
  std::vector<SubsetMeasure> subsets;
  std::shared_ptr<const std::vector<StartMeasure>> starts;
  std::size_t part_template = 0;
  std::size_t part = 0;
  friend bool operator==(const FigureKey&, const FigureKey&) = default;
};

struct PlotsState {
  std::string chosen = "members";  // that of the settings
  Evaluations evaluations;
  FigureKey key;
  std::shared_ptr<const Figure> figure;  // of the key; null: something is missing
  std::shared_ptr<const FitTable> stamped;
  std::uint64_t stamp = 0;  // of `stamped`
};

}  // namespace archetype
