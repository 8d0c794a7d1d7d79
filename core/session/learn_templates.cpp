// Rounds, their state in the project, and the fit at the end.
#include "core/session/learn_templates.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/random.h"
#include "core/io/template_file.h"
#include "core/learning/learning_round.h"
#include "core/session/fit_state.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;

// An outlier's energy is beyond this many times the bound of the learning set: the paper's 150 to 75.
constexpr double outlier_factor = 2;

struct State {
  std::string request;   // what is learned from what, as a hash
  bool settled = false;  // the last round kept nothing new
  std::vector<LearningStep> steps;
  std::vector<PartTemplate> start;  // what learning began with
  std::vector<TemplateId> ids;
  std::vector<LearnedTemplate> templates;
};

}  // namespace

ContentHash learn_request(const Project& project, const std::vector<PartTemplate>& initial,
                          const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed) {
  // Taken apart by position, so that an option which is added there and forgotten here does not compile.
  const auto& [iterations, sample_size, learning_share, tau, means, spreads, feature_spread, agreeing_share,
               cluster_share, smallest_cluster, noise] = options;
  std::string text = fit_state(initial, fit_options).to_hex() + "\n" + std::to_string(seed) + "\n";
  for (const double value :
       {static_cast<double>(iterations), static_cast<double>(sample_size), learning_share, tau, means,
        spreads, feature_spread, agreeing_share, cluster_share, static_cast<double>(smallest_cluster), noise})
    text += number_text(value) + "\n";
  for (const ShapeRecord& shape : project.shapes()) {
    text += shape.name + " " + shape.hash.to_hex() + " " + std::string(to_string(shape.up)) + " " +
            std::to_string(shape.requested_points) + " " + std::to_string(shape.seed) + "\n";
  }
  return hash_content(std::as_bytes(std::span(text)));
}

namespace {

void store_state(Project& project, const State& state) {
  Json json{{"request", state.request}, {"settled", state.settled}, {"templates", state.ids}};
  json["start"] = Json::array();
  for (const PartTemplate& each : state.start) json["start"].push_back(format_template(each));
  json["initial"] = Json::array();
  for (const LearnedTemplate& each : state.templates)
    json["initial"].push_back(format_template(each.initial));
  json["steps"] = Json::array();
  for (const LearningStep& step : state.steps) {
    json["steps"].push_back({{"iteration", step.iteration},
                             {"templates", step.templates},
                             {"energy_before", step.energy_before},
                             {"energy", step.energy}});
  }
  project.set_setting(std::string(learn_state_setting), json.dump());
}

// Nothing if there is none, or what the file holds is not one: then learning starts over.
std::optional<State> stored_state(const Project& project) {
  const std::optional<std::string> text = project.setting(std::string(learn_state_setting));
  if (!text) return std::nullopt;
  try {
    const Json json = Json::parse(*text);
    State state;
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
      state.templates.push_back({std::move(record->part_template), std::move(initial)});
    }
    for (const Json& step : json.at("steps"))
      state.steps.push_back({step.at("iteration").get<int>(), step.at("templates").get<std::size_t>(),
                             step.at("energy_before").get<double>(), step.at("energy").get<double>()});
    return state;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// `count` of the shapes, in their order, which is that of their names: ids tell when a shape was imported.
std::vector<ShapeId> draw(const std::vector<ShapeId>& shapes, std::size_t count, std::uint64_t seed) {
  std::vector<ShapeId> drawn;
  for (const std::size_t i : random_subset(shapes.size(), count, seed)) drawn.push_back(shapes[i]);
  return drawn;
}

// A small collection judges as a whole.
std::vector<ShapeId> judging_shapes(const std::vector<ShapeId>& shapes, const LearnOptions& options,
                                    std::uint64_t seed) {
  if (shapes.size() <= 2 * options.sample_size) return shapes;
  return draw(shapes, options.sample_size, derive_seed(seed, 0));
}

// False if cancelled.
bool load(const Project& project, const std::vector<ShapeId>& ids, const JobControl& control,
          std::vector<ShapeSamples>& samples) {
  for (const ShapeId id : ids) {
    if (control.cancelled()) return false;
    samples.push_back(project.samples(id));
  }
  return true;
}

class LearnRun {
 public:
  LearnRun(Project& project, const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed,
           unsigned threads, const JobControl& control)
      : project_(project),
        fit_options_(fit_options),
        options_(options),
        seed_(seed),
        threads_(threads),
        control_(control) {}

  LearnReport run(const std::vector<PartTemplate>& initial, bool fresh) {
    const Clock::time_point begun = Clock::now();
    begin(initial, fresh);
    const bool all = learn();
    const Clock::time_point learned_at = Clock::now();
    report_.learning_seconds = std::chrono::duration<double>(learned_at - begun).count();
    report_.steps = state_.steps;
    report_.cancelled = !all;
    if (!all) return std::move(report_);
    std::vector<PartTemplate> learned;
    for (const LearnedTemplate& each : state_.templates) learned.push_back(each.part_template);
    report_.fit = fit_collection(project_, learned, fit_options_, threads_, control_);
    report_.cancelled = report_.fit.cancelled;
    if (!report_.cancelled) mark_fits();
    report_.fitting_seconds = std::chrono::duration<double>(Clock::now() - learned_at).count();
    return std::move(report_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void begin(const std::vector<PartTemplate>& initial, bool fresh) {
    const std::string request = learn_request(project_, initial, fit_options_, options_, seed_).to_hex();
    if (!fresh) {
      std::optional<State> stored = stored_state(project_);
      if (stored && stored->request == request) {
        state_ = std::move(*stored);
        return;
      }
    }
    Project::Transaction transaction(project_);
    const std::vector<TemplateRecord> current = project_.templates();
    for (const PartTemplate& each : initial) {
      const auto same = std::ranges::find(current, each, &TemplateRecord::part_template);
      TemplateRecord record;
      record.part_template = each;
      state_.ids.push_back(same != current.end() ? same->id : project_.add_template(record));
      state_.templates.push_back({each, each});
    }
    state_.request = request;
    state_.start = initial;
    project_.set_current_templates(state_.ids);
    store_state(project_, state_);
    transaction.commit();
  }

  // False if cancelled.
  bool learn() {
    const std::vector<ShapeId> shapes = project_.shape_ids();
    const std::vector<ShapeId> judges = judging_shapes(shapes, options_, seed_);
    const std::set<ShapeId> judging_ids(judges.begin(), judges.end());
    std::vector<ShapeId> rest;
    for (const ShapeId id : shapes) {
      if (!judging_ids.contains(id)) rest.push_back(id);
    }
    std::vector<ShapeSamples> judging;
    if (!state_.settled && !load(project_, judges, control_, judging)) return false;
    while (!state_.settled && static_cast<int>(state_.steps.size()) < options_.iterations) {
      const int iteration = static_cast<int>(state_.steps.size()) + 1;
      std::vector<ShapeSamples> others;
      const auto key = static_cast<std::uint64_t>(iteration);
      if (!load(project_, draw(rest, options_.sample_size, derive_seed(seed_, key)), control_, others))
        return false;
      const auto round =
          learning_round(state_.templates, judging, others, fit_options_, options_, threads_,
                         round_control(iteration, judging.size() + others.size(), judging.size()));
      if (!round) return false;
      keep(*round, iteration);
    }
    return true;
  }

  // Says which round it is and counts the shapes that are fitted in it, to each template and proposal. How
  // many proposals there will be is not known before: the total grows with them.
  JobControl round_control(int iteration, std::size_t shapes, std::size_t judges) {
    JobControl round;
    round.stop = control_.stop;
    std::string what = "learning, round " + std::to_string(iteration) + " of at most " +
                       std::to_string(options_.iterations) +
                       ", templates: " + std::to_string(state_.templates.size());
    if (!state_.steps.empty())
      what += ", energy " + number_text(std::round(state_.steps.back().energy * 1e4) / 1e4);
    what += ", shapes fitted:";
    const std::size_t sure = state_.templates.size() * (shapes + judges);  // as it is, and re-estimated
    fitted_in_round_ = 0;
    round.report = [this, what, sure](std::size_t done, std::size_t total, std::string_view) {
      const std::size_t fitted = ++fitted_in_round_;
      control_.progress(fitted, std::max(sure, fitted + total - std::min(done, total)), what);
    };
    return round;
  }

  // One transaction a round.
  void keep(const LearningRound& round, int iteration) {
    Project::Transaction transaction(project_);
    std::vector<TemplateId> ids;
    for (std::size_t t = 0; t < round.templates.size(); ++t) {
      const TemplateOrigin& origin = round.origins[t];
      const TemplateId parent = state_.ids[origin.parent];
      if (!origin.changed) {
        ids.push_back(parent);
        continue;
      }
      TemplateRecord record;
      record.part_template = round.templates[t].part_template;
      record.iteration = iteration;
      record.parent = parent;
      ids.push_back(project_.add_template(record));
    }
    state_.ids = ids;
    state_.templates = round.templates;
    state_.settled = !round.changed();
    state_.steps.push_back({iteration, ids.size(), round.energy_before, round.energy});
    project_.set_current_templates(ids);
    store_state(project_, state_);
    transaction.commit();
  }

  // Which fits the templates stand for, and which they do not explain.
  void mark_fits() {
    const std::vector<FitSummary> fits = project_.fits();
    std::map<TemplateId, double> least;
    for (const FitSummary& fit : fits) {
      const auto [entry, fresh] = least.try_emplace(fit.part_template, fit.energy.total());
      entry->second = std::min(entry->second, fit.energy.total());
    }
    Project::Transaction transaction(project_);
    for (const FitSummary& fit : fits) {
      const double bound = options_.tau * least[fit.part_template];
      FitStatus status = FitStatus::fitted;
      if (fit.energy.total() <= bound) status = FitStatus::learned;
      if (fit.energy.total() > outlier_factor * bound) status = FitStatus::outlier;
      report_.learned += status == FitStatus::learned;
      report_.outliers += status == FitStatus::outlier;
      if (status != fit.status) project_.set_fit_status(fit.shape, status);
    }
    transaction.commit();
  }

  Project& project_;
  const FitOptions& fit_options_;
  const LearnOptions& options_;
  std::uint64_t seed_;
  unsigned threads_;
  const JobControl& control_;
  State state_;
  std::atomic<std::size_t> fitted_in_round_ = 0;
  LearnReport report_;
};

}  // namespace

std::vector<PartTemplate> learning_start(const Project& project) {
  std::vector<TemplateId> ids;
  std::vector<PartTemplate> current;
  for (TemplateRecord& record : project.templates()) {
    ids.push_back(record.id);
    current.push_back(std::move(record.part_template));
  }
  std::optional<State> stored = stored_state(project);
  if (stored && stored->ids == ids) return std::move(stored->start);
  return current;
}

std::optional<double> energy_after_trial(const Project& project, const PartTemplate& start,
                                         const FitOptions& fit_options, const LearnOptions& options,
                                         std::uint64_t seed, unsigned threads, const JobControl& control) {
  // What a candidate gains later is little beside what parts the candidates.
  constexpr int rounds = 2;
  if (project.shape_count() == 0) throw PreconditionError("there is no shape to learn from");
  std::vector<ShapeSamples> judging;
  if (!load(project, judging_shapes(project.shape_ids(), options, seed), control, judging))
    return std::nullopt;
  std::vector<LearnedTemplate> templates{{start, start}};
  double energy = 0;
  for (int round = 0; round < rounds; ++round) {
    auto learned = learning_round(templates, judging, {}, fit_options, options, threads, control);
    if (!learned) return std::nullopt;
    templates = std::move(learned->templates);
    energy = learned->energy;
    if (!learned->changed()) break;
  }
  return energy;
}

LearnReport learn_templates(Project& project, const std::vector<PartTemplate>& initial,
                            const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed,
                            bool fresh, unsigned threads, const JobControl& control) {
  if (initial.empty()) throw PreconditionError("there is no template to learn from");
  if (project.shape_count() == 0) throw PreconditionError("there is no shape to learn from");
  return LearnRun(project, fit_options, options, seed, threads, control).run(initial, fresh);
}

}  // namespace archetype
