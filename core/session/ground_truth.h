// Where the ground truth of a project lies: its true labels and landmarks.
#pragma once

#include <filesystem>

#include "core/io/project.h"

namespace archetype {

// Empty: not known.
struct GroundTruthFolders {
  std::filesystem::path labels;
  std::filesystem::path landmarks;
  friend bool operator==(const GroundTruthFolders&, const GroundTruthFolders&) = default;
};

// What was chosen last, or else folders named "labels" and "landmarks" beside the shapes or one above. Throws
// FileError where the project cannot be read.
GroundTruthFolders ground_truth_folders(const Project& project);

// For the next time. An empty folder leaves what was remembered.
void remember_ground_truth(Project& project, const GroundTruthFolders& folders);

}  // namespace archetype
