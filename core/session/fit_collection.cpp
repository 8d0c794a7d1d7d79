// Fits templates to the shapes of a project in parallel, labels their elements and commits in the order of
// names.
#include "core/session/fit_collection.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/evaluation/label_elements.h"
#include "core/fitting/agreed_yaws.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/pinned_labels.h"
#include "core/fitting/template_choice.h"
#include "core/session/commit_pace.h"
#include "core/session/current_templates.h"
#include "core/session/fit_state.h"
#include "core/session/learned_yaws.h"
#include "core/session/ordered_pipeline.h"
#include "core/session/read_imported.h"
#include "core/session/yaw_energies.h"
#include "core/session/yaw_votes.h"

namespace archetype {

namespace {

// One shape on its way through.
struct Work {
  ShapeRecord shape;
  ShapeSamples samples;
  const ShapeCorrection* correction = nullptr;  // null: none
  std::optional<ShapeFit> fit;
  std::size_t part_template = 0;
  bool fit_is_stored = false;  // by a run that could not label it
  std::optional<std::vector<std::int16_t>> labels;
  std::string refused;  // the reason, or empty

  std::vector<PinnedLabel> pinned(const PartTemplate& of) const {
    if (!correction || correction->sampling != sampling_of(shape)) return {};
    return pinned_labels(correction->pinned, of, samples.size());
  }
  bool cancelled = false;
};

// The ids of the templates in the project, which has them as its current set afterwards, and the options.
std::vector<TemplateId> store_request(Project& project, const std::vector<PartTemplate>& templates,
                                      const FitOptions& options) {
  Project::Transaction transaction(project);
  std::vector<TemplateRecord> current = project.templates();
  std::vector<TemplateId> ids;
  for (const PartTemplate& part_template : templates) {
    const auto same = std::ranges::find(current, part_template, &TemplateRecord::part_template);
    if (same != current.end()) {
      ids.push_back(same->id);
      current.erase(same);
    } else {
      TemplateRecord record;
      record.part_template = part_template;
      ids.push_back(project.add_template(record));
    }
  }
  project.set_current_templates(ids);
  nlohmann::ordered_json named;
  for (const auto& [name, value] : named_options(options)) named[name] = value;
  project.set_setting(fit_options_setting, named.dump());
  transaction.commit();
  return ids;
}

class FitRun {
 public:
  FitRun(Project& project, const std::vector<PartTemplate>& templates, const FitOptions& options,
         const JobControl& control)
      : project_(project), templates_(templates), options_(options), control_(control) {
    stop_only_.stop = control.stop;
    corrections_ = project.corrections();
    state_ = fit_state(templates_, options_);
    for (const PartTemplate& each : templates) template_names_.push_back(each.name);
  }

  FitCollectionReport run(unsigned threads) {
    template_ids_ = store_request(project_, templates_, options_);
    find_work(project_.shape_ids());
    return fit_todo(threads);
  }

  // The templates are those that the project has, by these ids.
  FitCollectionReport run_corrected(std::span<const ShapeId> shapes, std::vector<TemplateId> template_ids,
                                    unsigned threads) {
    template_ids_ = std::move(template_ids);
    std::vector<ShapeId> meant;
    for (const ShapeId id : shapes) {
      const ShapeCorrection* correction = correction_of(id);
      if (project_.fit(id) && (!correction || can_be_heeded(*correction, templates_))) meant.push_back(id);
    }
    find_work(meant);
    return fit_todo(threads);
  }

 private:
  Work& slot(std::size_t i) { return ring_[i % ring_.size()]; }

  FitCollectionReport fit_todo(unsigned threads) {
    if (!agree_on_yaws(threads)) {
      report_.cancelled = true;
      return std::move(report_);
    }
    ring_.resize(pipeline_window(threads));
    const bool all = ordered_pipeline(todo_.size(), threads, control_, "fitting",
                                      {.prepare = [this](std::size_t i) { load(i); },
                                       .compute = [this](std::size_t i) { compute(slot(i)); },
                                       .finish = [this](std::size_t i) { take(i); }});
    commit();
    report_.cancelled = report_.cancelled || !all;
    return std::move(report_);
  }

  // Of the shapes, those without a fit of these templates, options and corrections, or without labels.
  void find_work(const std::vector<ShapeId>& shapes) {
    std::vector<ShapeId> done;
    for (const FitSummary& fit : project_.fits()) {
      if (fit.state == state_of(fit.shape) && fit.has_labels) done.push_back(fit.shape);
    }
    std::ranges::sort(done);
    for (const ShapeId id : shapes) {
      if (!std::ranges::binary_search(done, id)) todo_.push_back(id);
    }
    report_.kept = shapes.size() - todo_.size();
  }

  const ShapeCorrection* correction_of(ShapeId id) const {
    const auto found = corrections_.find(id);
    return found == corrections_.end() ? nullptr : found->second.get();
  }
  ContentHash state_of(ShapeId id) const { return corrected_fit_state(state_, correction_of(id)); }
  FitStatus status_of(ShapeId id) const {
    const ShapeCorrection* correction = correction_of(id);
    if (!correction || correction->mark == ShapeMark::none) return FitStatus::fitted;
    return correction->mark == ShapeMark::outlier ? FitStatus::outlier : FitStatus::learned;
  }

  // A fit of this run's templates, options and corrections; or one that only a mark tells apart, which
  // counts for learning and leaves the fit as it is.
  std::optional<FitRecord> same_fit(ShapeId id) const {
    std::optional<FitRecord> stored = project_.fit(id);
    if (!stored) return stored;
    const ShapeCorrection* now = correction_of(id);
    ShapeCorrection before = now ? *now : ShapeCorrection{};
    for (const ShapeMark mark : {ShapeMark::none, ShapeMark::outlier, ShapeMark::learn}) {
      before.mark = mark;
      if (stored->state == corrected_fit_state(state_, &before)) return stored;
    }
    return std::nullopt;
  }

  std::optional<int> known_yaw(ShapeId id) const {
    const auto known = known_yaws_.find(id);
    return known == known_yaws_.end() ? std::nullopt : std::optional(known->second);
  }

  // False if cancelled.
  bool agree_on_yaws(unsigned threads) {
    const auto need_not_ask = [this](ShapeId id) {
      const ShapeCorrection* correction = correction_of(id);
      return (correction && correction->yaw_quarters) || same_fit(id).has_value();
    };
    if (std::ranges::all_of(todo_, need_not_ask)) return true;
    known_yaws_ = learned_yaws(project_, template_ids_);
    const std::vector<ShapeId> asked = yaw_voters(project_, known_yaws_);
    std::vector<ShapeSamples> references;
    for (std::size_t i = 0; i < asked.size() && !control_.cancelled(); ++i)
      references.push_back(project_.samples(asked[i]));
    if (control_.cancelled()) return false;
    const ContentHash state = yaw_energies_state(project_, state_, asked);
    std::optional<YawEnergies> energies = kept_yaw_energies(project_, state, asked.size());
    if (!energies) {
      energies = find_yaw_energies(references, threads);
      if (!energies) return false;
      keep_yaw_energies(project_, state, *energies);
    }
    for (std::size_t i = 0; i < asked.size(); ++i) add_cost_of_turning((*energies)[i], known_yaw(asked[i]));
    agreed_.emplace(references, *energies, stop_only_);
    return !control_.cancelled();
  }

  // Nothing if cancelled.
  std::optional<YawEnergies> find_yaw_energies(const std::vector<ShapeSamples>& references,
                                               unsigned threads) const {
    YawEnergies energies(references.size());
    const bool all = parallel_for(references.size(), threads, control_, "finding which way shapes face",
                                  [&](std::size_t i) {
                                    try {
                                      if (const auto best = best_fit(references[i], options_, nullptr))
                                        energies[i] = best->fit.yaw_energies;
                                    } catch (const NumericError&) {  // to be refused when its turn comes
                                    }
                                  });
    if (!all || control_.cancelled()) return std::nullopt;
    return energies;
  }

  void load(std::size_t i) {
    Work& work = slot(i) = {};
    work.shape = project_.find_shape(todo_[i]).value();
    work.samples = project_.samples(todo_[i]);
    work.correction = correction_of(todo_[i]);
    std::optional<FitRecord> stored = same_fit(todo_[i]);
    if (!stored) return;
    const auto id = std::ranges::find(template_ids_, stored->part_template);
    if (id == template_ids_.end()) return;
    work.fit = std::move(stored->fit);
    work.part_template = static_cast<std::size_t>(id - template_ids_.begin());
    work.fit_is_stored = stored->state == state_of(todo_[i]);
  }

  void compute(Work& work) const {
    try {
      if (!work.fit) find_best_fit(work);
      work.cancelled = control_.cancelled();
      if (!work.cancelled) label_file(work);
    } catch (const std::exception& error) {
      work.refused = error.what();
    }
  }

  struct BestFit {
    ShapeFit fit;
    std::size_t part_template = 0;
  };
  // Heeds what was corrected of the shape of `work`, if it is given. Nothing if cancelled.
  std::optional<BestFit> best_fit(const ShapeSamples& samples, const FitOptions& options,
                                  const Work* work) const {
    std::optional<BestFit> best;
    double least = 0;
    const bool corrected = work && work->correction;
    const std::vector<bool> allowed =
        allowed_templates(corrected ? *work->correction : ShapeCorrection{}, template_names_);
    for (std::size_t t = 0; t < templates_.size(); ++t) {
      if (!allowed[t]) continue;
      const auto pinned = corrected ? work->pinned(templates_[t]) : std::vector<PinnedLabel>{};
      std::optional<ShapeFit> fit =
          fit_template(templates_[t], samples, options, stop_only_, nullptr, pinned);
      if (!fit) return {};
      if (!std::isfinite(fit->energy.total())) throw NumericError("the fit has no finite energy");
      const double energy = choice_energy(*fit, templates_[t], samples, options) +
                            options.yaw_costs[static_cast<std::size_t>(fit->yaw_quarters)];
      if (best && energy >= least) continue;
      least = energy;
      best = {std::move(*fit), t};
    }
    return best;
  }

  void find_best_fit(Work& work) const {
    FitOptions options = options_;
    if (work.correction && work.correction->yaw_quarters) {
      options.yaw_costs = pinned_yaw_costs({}, *work.correction);
    } else {
      options.yaw_costs = agreed_->costs(work.samples);
      add_cost_of_turning(options.yaw_costs, known_yaw(work.shape.id));
    }
    std::optional<BestFit> best = best_fit(work.samples, options, &work);
    if (!best) return;
    work.fit = std::move(best->fit);
    work.part_template = best->part_template;
  }

  // Throws an Error that says why the elements cannot be labelled.
  void label_file(Work& work) const {
    const PartTemplate& part_template = templates_[work.part_template];
    work.labels = label_elements(read_imported(work.shape), work.samples, part_template, *work.fit, options_,
                                 stop_only_, work.pinned(part_template));
    if (!control_.cancelled()) return;
    work.labels.reset();
    work.cancelled = true;
  }

  void take(std::size_t i) {
    Work& work = slot(i);
    if (!work.refused.empty()) report_.refused.push_back({work.shape.path, work.refused});
    if (work.cancelled) {
      report_.cancelled = true;
      return;
    }
    if (!work.fit) return;
    ++(work.fit_is_stored ? report_.kept : report_.fitted);
    pending_.push_back(std::move(work));
    if (pace_.due(pending_.size(), control_)) commit();
  }

  void commit() {
    if (pending_.empty()) return;
    Project::Transaction transaction(project_);
    for (const Work& work : pending_) {
      if (!work.fit_is_stored) {
        const ShapeId id = work.shape.id;
        project_.store_fit({id, template_ids_[work.part_template], status_of(id), *work.fit, state_of(id)});
      }
      if (work.labels) project_.store_labels(work.shape.id, *work.labels);
    }
    transaction.commit();
    pending_.clear();
    pace_.committed();
  }

  Project& project_;
  const std::vector<PartTemplate>& templates_;
  const FitOptions& options_;
  const JobControl& control_;
  JobControl stop_only_;  // single fits do not report
  ContentHash state_;     // of shapes without corrections
  Corrections corrections_;
  std::vector<std::string> template_names_;
  KnownYaws known_yaws_;              // of shapes that the templates were learned from
  std::optional<AgreedYaws> agreed_;  // unless every shape has a fit or a pinned yaw
  std::vector<TemplateId> template_ids_;
  std::vector<ShapeId> todo_;
  std::vector<Work> ring_;
  std::vector<Work> pending_;  // to be committed
  CommitPace pace_;
  FitCollectionReport report_;
};

}  // namespace

FitCollectionReport fit_collection(Project& project, const std::vector<PartTemplate>& templates,
                                   const FitOptions& options, unsigned threads, const JobControl& control) {
  if (templates.empty()) throw PreconditionError("fit_collection needs at least one template");
  return FitRun(project, templates, options, control).run(threads);
}

FitCollectionReport fit_corrected(Project& project, std::span<const ShapeId> shapes, unsigned threads,
                                  const JobControl& control) {
  auto [templates, ids] = current_templates(project);
  if (templates.empty()) return {};
  const FitOptions options;
  return FitRun(project, templates, options, control).run_corrected(shapes, std::move(ids), threads);
}

}  // namespace archetype
