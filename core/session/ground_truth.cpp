#include "core/session/ground_truth.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

constexpr const char* labels_setting = "truth.labels";
constexpr const char* landmarks_setting = "truth.landmarks";

fs::path beside(const fs::path& shape, const char* name) {
  fs::path folder = shape.parent_path();
  for (int up = 0; up < 2 && folder.has_relative_path(); ++up) {
    folder = folder.parent_path();
    std::error_code none;
    if (fs::is_directory(folder / name, none)) return folder / name;
  }
  return {};
}

fs::path folder_of(const Project& project, const char* setting, const char* name) {
  if (const auto remembered = project.setting(setting)) return *remembered;
  const std::vector<ShapeRecord> first = project.shapes(0, 1);
  return first.empty() ? fs::path() : beside(first.front().path, name);
}

}  // namespace

GroundTruthFolders ground_truth_folders(const Project& project) {
  return {folder_of(project, labels_setting, "labels"), folder_of(project, landmarks_setting, "landmarks")};
}

void remember_ground_truth(Project& project, const GroundTruthFolders& folders) {
  if (!folders.labels.empty()) project.set_setting(labels_setting, folders.labels.string());
  if (!folders.landmarks.empty()) project.set_setting(landmarks_setting, folders.landmarks.string());
}

}  // namespace archetype
