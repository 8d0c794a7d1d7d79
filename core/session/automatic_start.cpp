// Suggestions, what came of trying them, and the project's memory of both.
#include "core/session/automatic_start.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/learn_templates.h"
#include "core/session/suggest_templates.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;

struct State {
  std::string request;  // what the choice depends on, as a hash
  std::vector<PartTemplate> candidates;
  std::vector<double> scores;  // of the candidates that were tried so far
  bool made = false;           // the choice: they are all in the project
};

void store_state(Project& project, const State& state) {
  Json json{{"request", state.request}, {"scores", state.scores}, {"made", state.made}};
  json["candidates"] = Json::array();
  for (const PartTemplate& each : state.candidates) json["candidates"].push_back(format_template(each));
  project.set_setting(std::string(start_state_setting), json.dump());
}

// Nothing if there is none, or what the file holds is not one: then the choice starts over.
std::optional<State> stored_state(const Project& project) {
  const std::optional<std::string> text = project.setting(std::string(start_state_setting));
  if (!text) return std::nullopt;
  try {
    const Json json = Json::parse(*text);
    State state;
    state.request = json.at("request").get<std::string>();
    state.scores = json.at("scores").get<std::vector<double>>();
    state.made = json.at("made").get<bool>();
    for (const Json& each : json.at("candidates"))
      state.candidates.push_back(parse_template(each.get<std::string>(), std::string(start_state_setting)));
    if (state.candidates.empty() || state.scores.size() > state.candidates.size() ||
        (state.made && state.scores.size() < state.candidates.size()))
      return std::nullopt;
    return state;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<PartTemplate> automatic_start(Project& project, const FitOptions& fit_options,
                                            const LearnOptions& options, std::uint64_t seed, bool fresh,
                                            unsigned threads, const JobControl& control) {
  const std::string request = learn_request(project, {}, fit_options, options, seed).to_hex();
  std::optional<State> state = stored_state(project);
  if (fresh || !state || state->request != request) {
    SuggestOptions suggest;
    suggest.seed = seed;
    const Suggestions suggestions = suggest_templates(project, suggest, threads, control);
    if (suggestions.cancelled) return std::nullopt;
    state = State{request, {}, {}, false};
    for (const InitialTemplate& each : suggestions.templates) state->candidates.push_back(each.part_template);
    store_state(project, *state);
  }
  const std::size_t count = state->candidates.size();
  while (state->scores.size() < count) {
    const std::size_t tried = state->scores.size();
    const std::string which =
        "trying suggestion " + std::to_string(tried + 1) + " of " + std::to_string(count) + ", fits:";
    const JobControl of_trial{control.stop, [&](std::size_t done, std::size_t total, std::string_view) {
                                control.progress(done, total, which);
                              }};
    const auto score =
        score_after_trial(project, state->candidates[tried], fit_options, options, seed, threads, of_trial);
    if (!score) return std::nullopt;
    state->scores.push_back(*score);
    store_state(project, *state);
  }
  const auto best = static_cast<std::size_t>(std::ranges::min_element(state->scores) - state->scores.begin());
  // What was learned from it since is current now, and stays so.
  if (!state->made) {
    Project::Transaction transaction(project);
    store_suggestions(project, state->candidates, best);
    state->made = true;
    store_state(project, *state);
    transaction.commit();
  }
  return state->candidates[best];
}

}  // namespace archetype
