// Templates to start learning from, made of nothing but the shapes (section 4.3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/learning/segment_shape.h"
#include "core/model/part_template.h"
#include "core/model/shape.h"

namespace archetype {

struct InitialTemplateOptions {
  SegmentationOptions segmentation;  // its solids do not count: both are tried
  std::size_t candidates = 10;       // to be returned, at most
  // What a part that other shapes have has to save in the score, so that parts are not free.
  double part_cost = 0.01;
};

// Some shapes of a collection, of which some are segmented and some (other ones or the same) scored with.
struct InitialShapes {
  std::vector<std::string> names;
  std::vector<ShapeSamples> samples;
  std::vector<std::size_t> segmented;  // indices into samples
  std::vector<std::size_t> scored;
};

struct InitialTemplate {
  PartTemplate part_template;
  double mean_energy = 0;  // of its fits to the scored shapes, without the existence term; to be told only
  double score = 0;        // mean start_score() of its fits once these have changed it; less is better
};

// How well a template stands for a shape, beside others that need not have as many parts: E_data of the fit,
// less a little for each part that the shape has, so that of two that are as near the one with more parts is
// the better one. The energy that learning lowers would not do: the spreads of each part make it a density,
// and of two templates the one with more parts has less of that, however badly it fits: a dozen staves for
// the body of a vase. What parts must exist does not count.
double start_score(double misfit, double parts);

// The best first. Candidates are the segmentations of each shape, one into boxes and one with round parts,
// and the best of them with parts that they lack and other shapes have (recurring_parts.h). Of near
// duplicates only the best one comes. Needs a segmented and a scored shape. Deterministic for any number of
// threads; the time is that of about 2 x (segmented shapes + 2) x scored shapes fits, and twice as many of
// one yaw. Nothing when cancelled.
//
// Differs from the paper, which takes the templates with the least fitting energy as they are: how far a
// template that was made of one shape has to be bent for others says little once it has been estimated from
// these. Existence is what the fits show.
std::optional<std::vector<InitialTemplate>> initial_templates(const InitialShapes& shapes,
                                                              const InitialTemplateOptions& options,
                                                              unsigned threads, const JobControl& control);

}  // namespace archetype
