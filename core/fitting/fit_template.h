// Section 4.1 as a whole: fits one template to one shape.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/fitting/alpha_expansion.h"
#include "core/fitting/fit_options.h"
#include "core/fitting/pinned_labels.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"
#include "core/model/shape_fit.h"

namespace archetype {

// The state after each alternation, for inspection: entry 0 is the boxes that it began with, without labels.
struct FitRecording {
  std::vector<ShapeFit> steps;
};

// Alternates labelling, correspondences, rigid and deformation steps from each candidate yaw until the labels
// stop changing, takes the yaw with the least energy, goes on there with round solids in the boxes of parts
// that are round on this shape (choose_solids.h), and then without the parts that the shape gives no evidence
// for (evidence.h), one after the other; the energy may rise when a part goes. Parts that hardly any shape
// has go before yaws are compared, where they come near the best, if this one gives no evidence for them; and
// that they are there costs nothing then. What is found so is tried once more from boxes that it carries
// (starting_boxes.h), and kept if that is better. The template needs at least one part; the samples at least
// one point. A cancelled fit returns nothing.
// `recording`, if given, receives the alternations that led to the fit: of the first try or of the second.
// Samples of `pinned` (pinned_labels.h) keep their labels, and their parts are not dropped. Deterministic;
// about 40 ms for 1,000 samples, 8 parts and 4 yaws.
std::optional<ShapeFit> fit_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                     const FitOptions& options, const JobControl& control = {},
                                     FitRecording* recording = nullptr,
                                     std::span<const PinnedLabel> pinned = {});

// The same from a fit that is near already: its yaw, translation and labels are the start, no other yaw is
// tried, and nothing once more.
std::optional<ShapeFit> refit_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                       const ShapeFit& start, const FitOptions& options,
                                       const JobControl& control = {},
                                       std::span<const PinnedLabel> pinned = {});

// As refit_template(), in a fraction of its time, for live editing: a box was moved a little. Parts stay as
// round as `start` has them. graph: make_point_graph(samples, options), made once for all fits of the shape.
std::optional<ShapeFit> follow_template(const PartTemplate& part_template, const ShapeSamples& samples,
                                        const LabellingGraph& graph, const ShapeFit& start,
                                        const FitOptions& options, const JobControl& control = {},
                                        std::span<const PinnedLabel> pinned = {});

}  // namespace archetype
