// The figure that is shown, and where what it is made of comes from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "ui/plots_state.h"

namespace archetype {

struct Studio;

// Changes when any shape is fitted anew.
std::uint64_t stamp_of(std::span<const FitSummary> fits);

// The template that plots and sliders are of: that of the selected part, or else the one that most shapes
// have. An index into the table's templates; nothing where there is none.
std::optional<std::size_t> template_in_focus(const Studio& studio, const FitTable& table);
// Its selected part; 0 where none of it is selected.
std::size_t part_in_focus(const Studio& studio, const FitTable& table, std::size_t part_template);

// Boxes to choose both by, side by side. All panels follow.
void choose_template(Studio& studio, const FitTable& table, std::size_t chosen, float width);
void choose_part(Studio& studio, const FitTable& table, std::size_t part_template, float width);

const PlotEntry& chosen_plot(const Studio& studio);
// Null where something is missing. To be called once a frame by what shows it.
std::shared_ptr<const Figure> use_figure(Studio& studio);
// The fits have changed since what the chosen plot shows was evaluated.
bool evaluated_before(const Studio& studio);

// Compares with ground truth in a folder, which the project remembers; and measures how learning grows with
// the collection, and what comes of several templates to begin with. Jobs.
void evaluate_labels(Studio& studio, const std::filesystem::path& folder);
void evaluate_marks(Studio& studio, const std::filesystem::path& folder);
void measure_sizes(Studio& studio);
void measure_starts(Studio& studio);

}  // namespace archetype
