#include "core/session/ground_truth.h"

#include <nlohmann/json.hpp>

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

std::string to_text(const GroundTruthFolders& folders) {
  const nlohmann::json json{folders.labels.string(), folders.landmarks.string()};
  return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

GroundTruthFolders ground_truth_from(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_array() || json.size() != 2 || !json[0].is_string() || !json[1].is_string()) return {};
  return {json[0].get<std::string>(), json[1].get<std::string>()};
}

void remember_ground_truth(Project& project, const GroundTruthFolders& folders) {
  if (!folders.labels.empty()) project.set_setting(labels_setting, folders.labels.string());
  if (!folders.landmarks.empty()) project.set_setting(landmarks_setting, folders.landmarks.string());
}

}  // namespace archetype
