// How each plot is made of its sources, which have what it needs. For plot_catalog.cpp.
#pragma once

#include "core/report/plot_catalog.h"

namespace archetype {

// fit_plots.cpp
Figure plot_members(const PlotSources& sources);          // shapes by template
Figure plot_energies(const PlotSources& sources);         // how the energies are spread, by template
Figure plot_energy_terms(const PlotSources& sources);     // equation 1, term by term
Figure plot_part_presence(const PlotSources& sources);    // share of the shapes that have each part
Figure plot_part_parameters(const PlotSources& sources);  // histograms with the template's Gaussians

// learning_plots.cpp
Figure plot_learning_energy(const PlotSources& sources);
Figure plot_learning_templates(const PlotSources& sources);
Figure plot_learning_sizes(const PlotSources& sources);   // figure 12
Figure plot_learning_starts(const PlotSources& sources);  // the numbers of figure 11

// accuracy_plots.cpp
Figure plot_accuracy_by_label(const PlotSources& sources);
Figure plot_accuracy_by_part(const PlotSources& sources);
Figure plot_accuracy_by_shape(const PlotSources& sources);
Figure plot_confusion(const PlotSources& sources);

// correspondence_plots.cpp
Figure plot_correspondence(const PlotSources& sources);  // figure 10
Figure plot_correspondence_by_landmark(const PlotSources& sources);

// Equal bins from `low` to `high` (low < high): as bars of kind SeriesKind::bars. Values outside, and what is
// not finite, are left out. `shapes`: the one of each value, or none at all.
PlotSeries histogram(std::span<const double> values, double low, double high, std::size_t bins,
                     std::span<const ShapeId> shapes = {});

}  // namespace archetype
