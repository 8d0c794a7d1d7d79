#include "core/session/learning_state.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/learned_yaws.h"

namespace archetype {
namespace {

using Json = nlohmann::ordered_json;

// Throws InputError for what is no count.
std::size_t read_index(const Json& json) {
  if (!json.is_number_unsigned()) throw InputError("learn.state", "", "expected an index");
  return json.get<std::size_t>();
}

std::vector<std::size_t> read_indices(const Json& json) {
  std::vector<std::size_t> indices;
  for (const Json& each : json) indices.push_back(read_index(each));
  return indices;
}

// Every index has what it stands for.
bool is_sound(const LearningState& state) {
  if (state.start.empty() || state.start.size() > state.lines.size()) return false;
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    if (state.lines[i].parent.has_value() != (i >= state.start.size())) return false;
    if (state.lines[i].parent && *state.lines[i].parent >= i) return false;
  }
  if (!std::ranges::all_of(state.templates, [](const LearnedTemplate& each) {
        return std::ranges::is_sorted(each.undivided);
      }))
    return false;
  for (const LearningStep& step : state.steps) {
    const auto less_than = [](std::size_t count) { return [count](std::size_t i) { return i < count; }; };
    if (step.templates.empty() || step.lines.size() != step.templates.size()) return false;
    if (!std::ranges::all_of(step.lines, less_than(state.lines.size()))) return false;
    if (step.taken.size() != state.judging.size()) return false;
    if (!std::ranges::all_of(step.taken, less_than(step.templates.size()))) return false;
  }
  return state.steps.empty() ? state.ids.size() == state.start.size()
                             : state.ids == state.steps.back().templates;
}

// None unless there is one for each judging shape.
std::vector<int> stored_yaws(const Project& project, const LearningState& state) {
  const KnownYaws known = learned_yaws(project, state.ids);
  std::vector<int> yaws;
  for (const ShapeId id : state.judging) {
    const auto found = known.find(id);
    if (found == known.end()) return {};
    yaws.push_back(found->second);
  }
  return yaws;
}

}  // namespace

void store_learning_state(Project& project, const LearningState& state) {
  Json json{{"request", state.request}, {"settled", state.settled}, {"templates", state.ids}};
  json["start"] = Json::array();
  for (const PartTemplate& each : state.start) json["start"].push_back(format_template(each));
  json["initial"] = Json::array();
  for (const LearnedTemplate& each : state.templates)
    json["initial"].push_back(format_template(each.initial));
  json["undivided"] = Json::array();
  for (const LearnedTemplate& each : state.templates) json["undivided"].push_back(each.undivided);
  json["judging"] = state.judging;
  json["lines"] = Json::array();
  for (const LearningLine& line : state.lines) {
    json["lines"].push_back({{"born", line.born}});
    if (line.parent) json["lines"].back()["parent"] = *line.parent;
  }
  json["steps"] = Json::array();
  for (const LearningStep& step : state.steps) {
    json["steps"].push_back({{"iteration", step.iteration},
                             {"energy_before", step.energy_before},
                             {"energy", step.energy},
                             {"templates", step.templates},
                             {"lines", step.lines},
                             {"taken", step.taken}});
  }
  project.set_setting(std::string(learn_state_setting), json.dump());
  const std::span known(state.judging.data(), state.yaws.size());
  keep_learned_yaws(project, state.ids, known, state.yaws);
}

std::optional<LearningState> stored_learning_state(const Project& project) {
  const std::optional<std::string> text = project.setting(std::string(learn_state_setting));
  if (!text) return std::nullopt;
  try {
    const Json json = Json::parse(*text);
    LearningState state;
    state.request = json.at("request").get<std::string>();
    state.settled = json.at("settled").get<bool>();
    for (const Json& each : json.at("start"))
      state.start.push_back(parse_template(each.get<std::string>(), "learn.state"));
    state.ids = json.at("templates").get<std::vector<TemplateId>>();
    for (std::size_t t = 0; t < state.ids.size(); ++t) {
      std::optional<TemplateRecord> record = project.find_template(state.ids[t]);
      if (!record) return std::nullopt;
      PartTemplate initial = parse_template(json.at("initial").at(t).get<std::string>(), "learn.state");
      if (initial.parts.size() != record->part_template.parts.size()) return std::nullopt;
      std::vector<std::size_t> undivided;
      if (json.contains("undivided")) undivided = read_indices(json.at("undivided").at(t));
      state.templates.push_back({std::move(record->part_template), std::move(initial), std::move(undivided)});
    }
    state.judging = json.at("judging").get<std::vector<ShapeId>>();
    for (const Json& line : json.at("lines")) {
      LearningLine& read = state.lines.emplace_back();
      read.born = static_cast<int>(read_index(line.at("born")));
      if (line.contains("parent")) read.parent = read_index(line.at("parent"));
    }
    for (const Json& step : json.at("steps")) {
      state.steps.push_back({static_cast<int>(read_index(step.at("iteration"))),
                             step.at("energy_before").get<double>(), step.at("energy").get<double>(),
                             step.at("templates").get<std::vector<TemplateId>>(),
                             read_indices(step.at("lines")), read_indices(step.at("taken"))});
    }
    if (!is_sound(state)) return std::nullopt;
    state.yaws = stored_yaws(project, state);
    return state;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace archetype
