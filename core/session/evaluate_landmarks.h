// The correspondences of a project against a folder of landmarks.
#pragma once

#include <filesystem>

#include "core/base/job_control.h"
#include "core/evaluation/correspondence_accuracy.h"
#include "core/io/project.h"

namespace archetype {

struct ShapeCorrespondences {
  std::string name;
  CorrespondenceCurves from;  // of its landmarks on all others
  CorrespondenceCurves to;    // of all others' landmarks on it
};

struct LandmarkEvaluation {
  CorrespondenceCurves all;                     // every ordered pair of shapes, every landmark that both have
  CorrespondenceCurves same_template;           // pairs that are fitted by one template
  std::uint64_t unmapped = 0;                   // of `all`: points for which no counterpart was found
  std::vector<CorrespondenceCurves> landmarks;  // by their place in the files
  std::vector<std::string> landmark_names;      // of names.txt in the folder, if it is there; else empty
  std::vector<ShapeCorrespondences> shapes;     // that took part, by name
  std::vector<std::string> without_landmarks;   // names of shapes that have no file of them
  std::vector<std::string> without_labels;      // names of shapes that no fit has labelled
  std::vector<RefusedInput> refused;            // files that could not be used
  bool cancelled = false;                       // what is above is not complete then
};

// SHAPE.vts in the folder: see read_landmarks(). A landmark of one shape is carried to another as
// map_points() does it, and compared with where the file has it there. Costs about 10 microseconds per pair
// and landmark.
LandmarkEvaluation evaluate_landmarks(const Project& project, const std::filesystem::path& folder,
                                      unsigned threads, const JobControl& control);

}  // namespace archetype
