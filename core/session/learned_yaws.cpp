#include "core/session/learned_yaws.h"

#include <nlohmann/json.hpp>

namespace archetype {
namespace {

using Json = nlohmann::json;

constexpr const char* setting_key = "learn.yaws";

}  // namespace

KnownYaws learned_yaws(const Project& project, const std::vector<TemplateId>& templates) {
  KnownYaws yaws;
  const Json kept = Json::parse(project.setting(setting_key).value_or(""), nullptr, false);
  if (!kept.is_object() || kept.value("templates", Json()) != Json(templates)) return yaws;
  for (const Json& each : kept.value("yaws", Json::array())) {
    if (!each.is_object() || !each.value("shape", Json()).is_number_unsigned() ||
        !each.value("yaw", Json()).is_number_unsigned())
      continue;
    const auto shape = project.find_shape(each["shape"].get<ShapeId>());
    const auto yaw = each["yaw"].get<std::uint64_t>();
    if (shape && yaw < 4 && each.value("sampling", Json()) == sampling_of(*shape).to_hex())
      yaws[shape->id] = static_cast<int>(yaw);
  }
  return yaws;
}

void keep_learned_yaws(Project& project, const std::vector<TemplateId>& templates,
                       std::span<const ShapeId> shapes, std::span<const int> yaws) {
  Json values = Json::array();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (const auto shape = project.find_shape(shapes[i])) {
      values.push_back({{"shape", shape->id}, {"sampling", sampling_of(*shape).to_hex()}, {"yaw", yaws[i]}});
    }
  }
  project.set_setting(setting_key, Json{{"templates", templates}, {"yaws", values}}.dump());
}

}  // namespace archetype
