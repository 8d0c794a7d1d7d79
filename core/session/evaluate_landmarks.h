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

// A shape that looks the same turned about up (see alike_turns()) has no front that could be found: a pair
// with one counts as well as it does with the one of these turns that brings all landmarks together nearest
// to where they should be. Everything but `as_marked` is counted so.
struct LandmarkEvaluation {
  CorrespondenceCurves all;                     // every ordered pair of shapes, every landmark that both have
  CorrespondenceCurves as_marked;               // the same without any such turn
  CorrespondenceCurves same_template;           // pairs that are fitted by one template
  std::uint64_t unmapped = 0;                   // of `all`: points for which no counterpart was found
  std::size_t turnable = 0;                     // shapes that look the same turned
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
