// How the correspondences of landmarks are shown.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/session/evaluate_landmarks.h"

namespace archetype {

nlohmann::ordered_json landmark_json(const LandmarkEvaluation& evaluation);
void print_landmark_report(const LandmarkEvaluation& evaluation);

// The curves of figure 10: threshold, then the share of correspondences within it, of all pairs and of those
// with one template, by diameter and by diagonal.
void write_curves(const std::filesystem::path& path, const LandmarkEvaluation& evaluation);

}  // namespace archetype
