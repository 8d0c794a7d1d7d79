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
  SegmentationOptions segmentation;
  std::size_t candidates = 10;  // to be returned, at most
  // What one more part has to save in the mean energy of the fits, so that parts are not free.
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
  double mean_energy = 0;  // of its fits to the scored shapes, without the existence term
  double score = 0;        // mean_energy + part_cost x parts; less is better
};

// The best first. Candidates are the segmentation of each shape, and the best of them with parts that they
// lack and other shapes have (recurring_parts.h). Of near duplicates only the best one comes. Needs a
// segmented and a scored shape. Deterministic for any number of threads; the time is that of about
// (segmented shapes + 30) x scored shapes fits. Nothing when cancelled.
//
// Differs from the paper, which takes the templates with the least fitting energy as they are: more parts
// always fit better, so each one has its price, and existence is what the fits show.
std::optional<std::vector<InitialTemplate>> initial_templates(const InitialShapes& shapes,
                                                              const InitialTemplateOptions& options,
                                                              unsigned threads, const JobControl& control);

}  // namespace archetype
