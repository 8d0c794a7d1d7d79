// Rounds, their state in the project, and the fit at the end.
#include "core/session/learn_templates.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/random.h"
#include "core/io/correction_text.h"
#include "core/learning/initial_templates.h"
#include "core/learning/learning_round.h"
#include "core/session/current_templates.h"
#include "core/session/fit_state.h"
#include "core/session/learning_corrections.h"
#include "core/session/learning_state.h"

namespace archetype {

namespace {

// Another one where the same request leads to other templates than before: what an earlier program began is
// not gone on with, but begun anew.
constexpr int method = 7;

}  // namespace

ContentHash learn_request(const Project& project, const std::vector<PartTemplate>& initial,
                          const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed) {
  // Taken apart by position, so that an option which is added there and forgotten here does not compile.
  const auto& [iterations, sample_size, learning_share, tau, outlier_factor, smallest_set, means, spreads,
               spread_factor, spread, feature_spread, agreeing_share, divided_share, least_gain,
               cluster_share, smallest_cluster, smallest_sure_cluster] = options;
  static_cast<void>(iterations);
  std::string text = std::to_string(method) + "\n" + fit_state(initial, fit_options).to_hex() + "\n" +
                     std::to_string(seed) + "\n";
  for (const double value :
       {static_cast<double>(sample_size), learning_share, tau, outlier_factor,
        static_cast<double>(smallest_set), means, spreads, spread_factor, spread, feature_spread,
        agreeing_share, divided_share, least_gain, cluster_share, static_cast<double>(smallest_cluster),
        static_cast<double>(smallest_sure_cluster)})
    text += number_text(value) + "\n";
  const Corrections corrections = project.corrections();
  for (const ShapeRecord& shape : project.shapes()) {
    text += shape.name + " " + shape.hash.to_hex() + " " + std::string(to_string(shape.up)) + " " +
            std::to_string(shape.requested_points) + " " + std::to_string(shape.seed) + "\n";
    const auto correction = corrections.find(shape.id);
    if (correction != corrections.end()) text += format_correction(*correction->second) + "\n";
  }
  return hash_content(std::as_bytes(std::span(text)));
}

namespace {

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

// What was learned on the way to what is wanted now.
bool is_of(const LearningState& stored, const std::string& request, const LearnOptions& options) {
  return stored.request == request && static_cast<int>(stored.steps.size()) <= options.iterations;
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
        control_(control),
        corrections_(project),
        shapes_(corrections_.without_outliers(project.shape_ids())) {}

  LearnReport run(const std::vector<PartTemplate>& initial, bool fresh) {
    const Clock::time_point begun = Clock::now();
    begin(initial, fresh);
    const bool all = learn();
    const Clock::time_point learned_at = Clock::now();
    report_.learning_seconds = std::chrono::duration<double>(learned_at - begun).count();
    report_.steps = state_.steps;
    report_.cancelled = !all;
    if (!all) return std::move(report_);
    // No round was wanted, or none was left and other templates were fitted since the last.
    if (state_.ids.empty() || current_templates(project_).ids != state_.ids) {
      Project::Transaction transaction(project_);
      if (state_.ids.empty()) add_start();
      store();
      transaction.commit();
    }
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
    const std::vector<ShapeId> judging = judging_shapes(shapes_, options_, seed_);
    if (!fresh) {
      std::optional<LearningState> stored = stored_learning_state(project_);
      if (stored && is_of(*stored, request, options_) && stored->judging == judging) {
        state_ = std::move(*stored);
        return;
      }
    }
    for (const PartTemplate& each : initial) state_.templates.push_back({each, each});
    state_.request = request;
    state_.start = initial;
    state_.judging = judging;
    state_.lines.resize(initial.size());
  }

  // Together with the first round: who stops before its end keeps what was there.
  void add_start() {
    const std::vector<TemplateRecord> current = project_.templates();
    for (const PartTemplate& each : state_.start) {
      const auto same = std::ranges::find(current, each, &TemplateRecord::part_template);
      TemplateRecord record;
      record.part_template = each;
      state_.ids.push_back(same != current.end() ? same->id : project_.add_template(record));
    }
  }

  void store() {
    project_.set_current_templates(state_.ids);
    store_learning_state(project_, state_);
  }

  // False if cancelled.
  bool learn() {
    const std::set<ShapeId> judging_ids(state_.judging.begin(), state_.judging.end());
    std::vector<ShapeId> rest;
    std::vector<ShapeId> always;
    for (const ShapeId id : shapes_) {
      if (!judging_ids.contains(id)) (corrections_.must_learn(id) ? always : rest).push_back(id);
    }
    std::vector<ShapeSamples> judging;
    if (!state_.settled && !load(project_, state_.judging, control_, judging)) return false;
    while (!state_.settled && static_cast<int>(state_.steps.size()) < options_.iterations) {
      const int iteration = static_cast<int>(state_.steps.size()) + 1;
      std::vector<ShapeSamples> others;
      const auto key = static_cast<std::uint64_t>(iteration);
      std::vector<ShapeId> other_ids = draw(rest, options_.sample_size, derive_seed(seed_, key));
      const std::vector<ShapeId> wanted = draw(always, options_.sample_size, derive_seed(seed_, key));
      other_ids.insert(other_ids.end(), wanted.begin(), wanted.end());
      for (LearnedTemplate& each : state_.templates)
        each.pinned = corrections_.is_pinned_to(each.part_template.name);
      if (!load(project_, other_ids, control_, others)) return false;
      std::vector<ShapeId> ids = state_.judging;
      ids.insert(ids.end(), other_ids.begin(), other_ids.end());
      const auto round = learning_round(state_.templates, judging, others, fit_options_, options_, threads_,
                                        round_control(iteration), corrections_.of(ids), state_.yaws);
      if (!round) return false;
      keep(*round, iteration);
    }
    return true;
  }

  // Says which round it is.
  JobControl round_control(int iteration) {
    JobControl round;
    round.stop = control_.stop;
    std::string what = "learning, round " + std::to_string(iteration) + " of at most " +
                       std::to_string(options_.iterations) +
                       ", templates: " + std::to_string(state_.templates.size());
    if (!state_.steps.empty())
      what += ", energy " + number_text(std::round(state_.steps.back().energy * 1e4) / 1e4);
    what += ", fits:";
    round.report = [this, what](std::size_t done, std::size_t total, std::string_view) {
      control_.progress(done, total, what);
    };
    return round;
  }

  // One transaction a round.
  void keep(const LearningRound& round, int iteration) {
    Project::Transaction transaction(project_);
    if (state_.ids.empty()) add_start();
    const std::vector<std::size_t> lines_before = state_.current_lines();
    LearningStep step{iteration, round.energy_before, round.energy, {}, {}, round.taken};
    std::vector<TemplateId>& ids = step.templates;
    for (std::size_t t = 0; t < round.templates.size(); ++t) {
      const TemplateOrigin& origin = round.origins[t];
      const TemplateId parent = state_.ids[origin.parent];
      // A re-estimated template keeps its name, and a spawned one has another.
      const bool spawned =
          round.templates[t].part_template.name != state_.templates[origin.parent].part_template.name;
      if (spawned) state_.lines.push_back({lines_before[origin.parent], iteration});
      step.lines.push_back(spawned ? state_.lines.size() - 1 : lines_before[origin.parent]);
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
    state_.yaws = round.yaws;
    state_.settled = !round.changed();
    state_.steps.push_back(std::move(step));
    store();
    transaction.commit();
  }

  // Which fits the templates stand for, and which they do not explain.
  void mark_fits() {
    std::vector<FitSummary> fits = project_.fits();
    std::map<TemplateId, double> least;
    // A shape that the new templates could not be fitted to keeps the fit that it had.
    std::erase_if(fits, [this](const FitSummary& fit) {
      return std::ranges::find(state_.ids, fit.part_template) == state_.ids.end();
    });
    for (const FitSummary& fit : fits) {
      if (corrections_.is_outlier(fit.shape)) continue;
      const auto [entry, fresh] = least.try_emplace(fit.part_template, fit.energy.total());
      entry->second = std::min(entry->second, fit.energy.total());
    }
    Project::Transaction transaction(project_);
    for (const FitSummary& fit : fits) {
      const double bound = options_.tau * least[fit.part_template];
      FitStatus status = FitStatus::fitted;
      if (fit.energy.total() <= bound) status = FitStatus::learned;
      if (fit.energy.total() > options_.outlier_factor * bound) status = FitStatus::outlier;
      if (corrections_.must_learn(fit.shape)) status = FitStatus::learned;
      if (corrections_.is_outlier(fit.shape)) status = FitStatus::outlier;
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
  const LearningCorrections corrections_;
  const std::vector<ShapeId> shapes_;  // that are learned from
  LearningState state_;
  LearnReport report_;
};

}  // namespace

std::optional<LearningRecord> learning_record(const Project& project) {
  std::optional<LearningState> state = stored_learning_state(project);
  if (!state) return std::nullopt;
  std::set<TemplateId> ids;
  for (const LearningStep& step : state->steps) ids.insert(step.templates.begin(), step.templates.end());
  LearningRecord record;
  for (const TemplateId id : ids) {
    std::optional<TemplateRecord> found = project.find_template(id);
    if (!found) return std::nullopt;
    record.templates.push_back(std::move(*found));
  }
  record.start = std::move(state->start);
  record.judging = std::move(state->judging);
  record.lines = std::move(state->lines);
  record.steps = std::move(state->steps);
  record.settled = state->settled;
  return record;
}

std::vector<PartTemplate> learning_start(const Project& project) {
  CurrentTemplates current = current_templates(project);
  std::optional<LearningState> stored = stored_learning_state(project);
  if (stored && stored->ids == current.ids) return std::move(stored->start);
  return std::move(current.templates);
}

bool can_go_on(const Project& project, const FitOptions& fit_options, const LearnOptions& options,
               std::uint64_t seed) {
  const std::optional<LearningState> stored = stored_learning_state(project);
  return stored &&
         is_of(*stored, learn_request(project, stored->start, fit_options, options, seed).to_hex(), options);
}

bool is_over(const LearningRecord& record, const LearnOptions& options) {
  return record.settled || static_cast<int>(record.steps.size()) >= options.iterations;
}

std::optional<double> score_after_trial(const Project& project, const PartTemplate& start,
                                        const FitOptions& fit_options, const LearnOptions& options,
                                        std::uint64_t seed, unsigned threads, const JobControl& control) {
  // What a candidate gains later is little beside what parts the candidates.
  constexpr int rounds = 2;
  if (project.shape_count() == 0) throw PreconditionError("there is no shape to learn from");
  const LearningCorrections corrections(project);
  const std::vector<ShapeId> ids =
      judging_shapes(corrections.without_outliers(project.shape_ids()), options, seed);
  std::vector<ShapeSamples> judging;
  if (!load(project, ids, control, judging)) return std::nullopt;
  std::vector<LearnedTemplate> templates{{start, start}};
  std::vector<int> yaws;
  LearnOptions undivided = options;
  undivided.smallest_cluster = judging.size() + 1;
  double score = 0;
  for (int round = 0; round < rounds; ++round) {
    auto learned = learning_round(templates, judging, {}, fit_options, undivided, threads, control,
                                  corrections.of(ids), yaws);
    if (!learned) return std::nullopt;
    templates = std::move(learned->templates);
    yaws = std::move(learned->yaws);
    score = start_score(learned->misfit, learned->parts);
    if (!learned->changed()) break;
  }
  return score;
}

LearnReport learn_templates(Project& project, const std::vector<PartTemplate>& initial,
                            const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed,
                            bool fresh, unsigned threads, const JobControl& control) {
  if (initial.empty()) throw PreconditionError("there is no template to learn from");
  if (project.shape_count() == 0) throw PreconditionError("there is no shape to learn from");
  return LearnRun(project, fit_options, options, seed, threads, control).run(initial, fresh);
}

}  // namespace archetype
