// Where the ground truth of a project lies: its true labels and landmarks.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

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

// In one line, to be stored with what was measured against them. Names that are no UTF-8 come back changed.
std::string to_text(const GroundTruthFolders& folders);
// Empty folders where the text is something else.
GroundTruthFolders ground_truth_from(std::string_view text);

// For the next time. An empty folder leaves what was remembered.
void remember_ground_truth(Project& project, const GroundTruthFolders& folders);

}  // namespace archetype
