// The labelling accuracy of a project against a folder of ground truth.
#pragma once

#include <filesystem>

#include "core/base/job_control.h"
#include "core/evaluation/labelling_accuracy.h"
#include "core/io/project.h"

namespace archetype {

// A part of the templates that the fits of a project use.
struct EvaluatedPart {
  std::string part_template;
  std::string part;
  int label = 0;
};

struct LabellingEvaluation {
  LabellingReport report;
  std::vector<ShapeId> shapes;             // of report.shapes
  std::vector<std::string> label_names;    // of the true labels, where `_labels.txt` or names.txt has them
  std::vector<EvaluatedPart> parts;        // what the report's part indices mean
  std::vector<std::string> without_truth;  // names of shapes that have no label file
  std::vector<std::string>
      without_labels;  // names of shapes that are not fitted or whose elements are not labelled
  std::vector<RefusedInput> refused;  // files that could not be used
  bool cancelled = false;             // the report is empty then
};

// Names in `_labels.txt` files are numbered as they first appear, shapes in the order of their names, so that
// all files agree. Label files are found by the names of the shapes (find_labels); areas come from the
// shapes' own files. A shape that lacks a label file, a labelled fit or its own file is listed and left out.
LabellingEvaluation evaluate_labelling(const Project& project, const std::filesystem::path& label_folder,
                                       unsigned threads, const JobControl& control);

}  // namespace archetype
