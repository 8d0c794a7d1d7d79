#include "core/session/measure_starts.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/measure_subsets.h"
#include "core/session/suggest_templates.h"

namespace archetype {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* setting_key = "report.starts";
constexpr std::size_t most_shapes = 200;

double mean_energy(const Project& project) {
  const std::vector<FitSummary> fits = project.fits();
  double sum = 0;
  for (const FitSummary& fit : fits) sum += fit.energy.total();
  return fits.empty() ? 0 : sum / static_cast<double>(fits.size());
}

Json to_json(const TruthShares& shares) {
  Json json = Json::object();
  if (shares.labelling) json["labelling"] = *shares.labelling;
  if (shares.best_labelling) json["best_labelling"] = *shares.best_labelling;
  if (shares.correspondence) json["correspondence"] = *shares.correspondence;
  return json;
}

TruthShares shares_from(const Json& json) {
  const auto share = [&](const char* name) {
    return json.contains(name) ? std::optional(json.at(name).get<double>()) : std::nullopt;
  };
  return {share("labelling"), share("best_labelling"), share("correspondence")};
}

PartTemplate template_from(const Json& json) {
  return parse_template(json.get<std::string>(), setting_key);
}

StartMeasure measure_from(const Json& json) {
  StartMeasure measure;
  measure.initial = template_from(json.at("initial"));
  for (const Json& each : json.at("learned")) measure.learned.push_back(template_from(each));
  measure.energy_before = json.at("energy_before").get<double>();
  measure.energy_after = json.at("energy_after").get<double>();
  measure.before = shares_from(json.at("before"));
  measure.after = shares_from(json.at("after"));
  measure.truth = ground_truth_from(json.value("truth", ""));  // earlier versions did not say
  return measure;
}

// Of a copy of the shapes. Nothing if cancelled.
std::optional<StartMeasure> measure_start(Project& shapes, const PartTemplate& start,
                                          const GroundTruthFolders& truth, std::uint64_t seed,
                                          unsigned threads, const JobControl& control) {
  StartMeasure measure;
  measure.initial = start;
  measure.truth = truth;
  if (fit_collection(shapes, {start}, {}, threads, control).cancelled) return std::nullopt;
  measure.energy_before = mean_energy(shapes);
  const auto before = truth_shares(shapes, truth, threads, control);
  if (!before) return std::nullopt;
  measure.before = *before;
  if (learn_templates(shapes, {start}, {}, {}, seed, true, threads, control).cancelled) return std::nullopt;
  for (TemplateRecord& each : shapes.templates()) measure.learned.push_back(std::move(each.part_template));
  measure.energy_after = mean_energy(shapes);
  const auto after = truth_shares(shapes, truth, threads, control);
  if (!after) return std::nullopt;
  measure.after = *after;
  return measure;
}

}  // namespace

std::optional<std::vector<StartMeasure>> measure_starts(const Project& project,
                                                        const std::vector<PartTemplate>& starts,
                                                        const GroundTruthFolders& truth, std::uint64_t seed,
                                                        unsigned threads, const JobControl& control) {
  std::vector<ShapeId> ids = in_random_order(project.shape_ids(), seed);
  if (ids.empty()) throw PreconditionError("there is no shape to learn from");
  ids.resize(std::min(ids.size(), most_shapes));
  std::vector<StartMeasure> measures;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    Project shapes = Project::in_memory();  // a new one each time: nothing of the start before is left
    for (const ShapeId id : ids) {
      if (control.cancelled()) return std::nullopt;
      if (const auto record = project.find_shape(id)) shapes.add_shape(*record, project.samples(id));
    }
    const std::string which =
        "start " + std::to_string(i + 1) + " of " + std::to_string(starts.size()) + ", ";
    const JobControl of_start{control.stop, [&](std::size_t done, std::size_t total, std::string_view what) {
                                control.progress(done, total, which + std::string(what));
                              }};
    std::optional<StartMeasure> measure = measure_start(shapes, starts[i], truth, seed, threads, of_start);
    if (!measure) return std::nullopt;
    measures.push_back(*std::move(measure));
  }
  return measures;
}

std::optional<std::vector<StartMeasure>> measure_suggested_starts(const Project& project,
                                                                  const GroundTruthFolders& truth,
                                                                  std::uint64_t seed, unsigned threads,
                                                                  const JobControl& control) {
  SuggestOptions options;
  options.seed = seed;
  options.initial.candidates = most_starts;
  const Suggestions suggestions = suggest_templates(project, options, threads, control);
  if (suggestions.cancelled) return std::nullopt;
  std::vector<PartTemplate> starts;
  for (const InitialTemplate& each : suggestions.templates) starts.push_back(each.part_template);
  return measure_starts(project, starts, truth, seed, threads, control);
}

void store_start_measures(Project& project, const std::vector<StartMeasure>& measures) {
  Json all = Json::array();
  for (const StartMeasure& each : measures) {
    Json json{{"initial", format_template(each.initial)}, {"learned", Json::array()}};
    for (const PartTemplate& learned : each.learned) json["learned"].push_back(format_template(learned));
    json["energy_before"] = each.energy_before;
    json["energy_after"] = each.energy_after;
    json["before"] = to_json(each.before);
    json["after"] = to_json(each.after);
    json["truth"] = to_text(each.truth);
    all.push_back(std::move(json));
  }
  project.set_setting(setting_key, all.dump());
}

std::vector<StartMeasure> stored_start_measures(const Project& project) {
  const std::optional<std::string> text = project.setting(setting_key);
  if (!text) return {};
  try {
    std::vector<StartMeasure> measures;
    for (const Json& each : Json::parse(*text)) measures.push_back(measure_from(each));
    return measures;
  } catch (const nlohmann::json::exception&) {
    return {};
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace archetype
