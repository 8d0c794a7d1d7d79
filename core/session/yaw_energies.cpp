#include "core/session/yaw_energies.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace archetype {
namespace {

using Json = nlohmann::json;

constexpr const char* setting_key = "fit.yaw_energies";

}  // namespace

ContentHash yaw_energies_state(const Project& project, const ContentHash& fit_state,
                               std::span<const ShapeId> references) {
  std::string text = fit_state.to_hex();
  for (const ShapeId id : references)
    if (const auto shape = project.find_shape(id)) text += sampling_of(*shape).to_hex();
  return hash_content(std::as_bytes(std::span(text)));
}

std::optional<YawEnergies> kept_yaw_energies(const Project& project, const ContentHash& state,
                                             std::size_t references) {
  const Json kept = Json::parse(project.setting(setting_key).value_or(""), nullptr, false);
  if (!kept.is_object() || kept.value("state", Json()) != state.to_hex()) return std::nullopt;
  const Json values = kept.value("energies", Json::array());
  if (!values.is_array() || values.size() != references) return std::nullopt;
  YawEnergies energies;
  for (const Json& each : values) {
    std::array<double, 4>& of_one = energies.emplace_back();
    of_one.fill(std::numeric_limits<double>::infinity());
    if (!each.is_array() || each.size() != of_one.size()) return std::nullopt;
    bool any = false;
    for (std::size_t yaw = 0; yaw < of_one.size(); ++yaw) {
      if (!each[yaw].is_number()) continue;
      of_one[yaw] = each[yaw].get<double>();
      any = any || std::isfinite(of_one[yaw]);
    }
    if (!any) return std::nullopt;
  }
  return energies;
}

void keep_yaw_energies(Project& project, const ContentHash& state, const YawEnergies& energies) {
  Json values = Json::array();
  for (const std::array<double, 4>& of_one : energies) {
    Json& each = values.emplace_back(Json::array());
    for (const double energy : of_one) each.push_back(std::isfinite(energy) ? Json(energy) : Json());
  }
  project.set_setting(setting_key, Json{{"state", state.to_hex()}, {"energies", values}}.dump());
}

}  // namespace archetype
