// Hashes the text of everything that decides a fit.
#include "core/session/fit_state.h"

#include "core/base/number_text.h"
#include "core/io/correction_text.h"
#include "core/io/template_file.h"

namespace archetype {

namespace {

// Another one where the same request leads to other fits than before, as the version of the program does not
// tell what was changed since it was given.
constexpr int method = 2;

}  // namespace

std::vector<std::pair<std::string, double>> named_options(const FitOptions& options) {
  // Taken apart by position, so that an option which is added there and forgotten here does not compile.
  const auto& [distance_unit, alpha, deformation_tail, turn_stddev, round_share, beta, gamma, null_cost,
               feature_clip, existence_weight, graph_neighbours, face_smoothness, crease_reach, face_core,
               face_neighbours, template_points, yaw_costs, max_alternations, drop_parts, odds_weight,
               expansion] = options;
  const auto& [prune] = expansion;
  return {{"distance_unit", distance_unit},
          {"alpha", alpha},
          {"deformation_tail", deformation_tail},
          {"turn_stddev", turn_stddev},
          {"round_share", round_share},
          {"beta", beta},
          {"gamma", gamma},
          {"null_cost", null_cost},
          {"feature_clip", feature_clip},
          {"existence_weight", existence_weight},
          {"graph_neighbours", graph_neighbours},
          {"face_smoothness", face_smoothness},
          {"crease_reach", crease_reach},
          {"face_core", face_core},
          {"face_neighbours", face_neighbours},
          {"template_points", template_points},
          {"yaw_cost_0", yaw_costs[0]},
          {"yaw_cost_90", yaw_costs[1]},
          {"yaw_cost_180", yaw_costs[2]},
          {"yaw_cost_270", yaw_costs[3]},
          {"max_alternations", max_alternations},
          {"drop_parts", drop_parts},
          {"odds_weight", odds_weight},
          {"prune", prune}};
}

ContentHash fit_state(const std::vector<PartTemplate>& templates, const FitOptions& options) {
  std::string text = "archetype " ARCHETYPE_VERSION ", method " + std::to_string(method) + "\n";
  for (const auto& [name, value] : named_options(options)) {
    text += name + "=" + number_text(value) + "\n";
  }
  for (const PartTemplate& part_template : templates) text += format_template(part_template);
  return hash_content(std::as_bytes(std::span(text)));
}

ContentHash corrected_fit_state(const ContentHash& state, const ShapeCorrection* correction) {
  if (!correction || correction->empty()) return state;
  const std::string text = state.to_hex() + format_correction(*correction);
  return hash_content(std::as_bytes(std::span(text)));
}

}  // namespace archetype
