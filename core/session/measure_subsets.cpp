#include "core/session/measure_subsets.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <span>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/random.h"
#include "core/session/current_templates.h"

namespace archetype {
namespace {

constexpr const char* setting_key = "report.subsets";
constexpr std::size_t smallest_subset = 8;
constexpr std::size_t largest_subset = 1000;
constexpr std::uint64_t order_key = 0x5b5e;  // of the stream that orders the shapes

constexpr std::size_t most_judging = 100;  // the paper's number of other models

// False if cancelled.
bool copy_shapes(const Project& from, std::span<const ShapeId> shapes, Project& to,
                 const JobControl& control) {
  for (const ShapeId shape : shapes) {
    if (control.cancelled()) return false;
    if (const auto record = from.find_shape(shape)) to.add_shape(*record, from.samples(shape));
  }
  return true;
}

// A number that was not measured is negative.
std::string share_text(const std::optional<double>& share) {
  return number_text(share.value_or(-1));
}

std::optional<double> read_share(double value) {
  return value >= 0 && value <= 1 ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<ShapeId> in_random_order(std::vector<ShapeId> shapes, std::uint64_t seed) {
  RandomStream random(derive_seed(seed, order_key));
  for (std::size_t i = shapes.size(); i > 1; --i) std::swap(shapes[i - 1], shapes[random.below(i)]);
  return shapes;
}

std::vector<std::size_t> subset_sizes(std::size_t shapes) {
  const std::size_t all = std::min(shapes, largest_subset);
  std::vector<std::size_t> sizes;
  for (std::size_t size = smallest_subset; 3 * size <= 2 * all; size *= 2) sizes.push_back(size);
  if (all > 0) sizes.push_back(all);
  return sizes;
}

std::optional<std::vector<SubsetMeasure>> measure_subsets(const Project& project,
                                                          const std::vector<PartTemplate>& start,
                                                          const std::vector<std::size_t>& sizes,
                                                          const GroundTruthFolders& truth, std::uint64_t seed,
                                                          unsigned threads, const JobControl& control) {
  const std::vector<ShapeId> shapes = in_random_order(project.shape_ids(), seed);
  const bool known = !truth.labels.empty() || !truth.landmarks.empty();
  const std::size_t held =
      known && shapes.size() >= least_shapes_to_judge ? std::min(most_judging, shapes.size() / 4) : 0;
  const std::size_t learnable = shapes.size() - held;
  Project judging = Project::in_memory();
  if (!copy_shapes(project, std::span(shapes).subspan(learnable), judging, control)) return std::nullopt;
  std::vector<SubsetMeasure> measures;
  Project subset = Project::in_memory();
  std::size_t taken = 0;
  for (const std::size_t size : sizes) {
    const std::size_t wanted = std::min(size, learnable);
    if (!measures.empty() && wanted <= taken) break;
    if (!copy_shapes(project, std::span(shapes).subspan(taken, wanted - taken), subset, control))
      return std::nullopt;
    taken = wanted;
    const LearnReport report = learn_templates(subset, start, {}, {}, seed, true, threads, control);
    if (report.cancelled) return std::nullopt;
    const std::vector<PartTemplate> learned = current_templates(subset).templates;
    SubsetMeasure measure{taken, learned.size(), report.learning_seconds, report.fitting_seconds};
    measure.truth = truth;
    if (held > 0) {
      if (fit_collection(judging, learned, {}, threads, control).cancelled) return std::nullopt;
      const auto accuracy = truth_shares(judging, truth, threads, control);
      if (!accuracy) return std::nullopt;
      if (*accuracy != TruthShares{}) measure.judging = held;
      measure.accuracy = *accuracy;
    }
    measures.push_back(measure);
  }
  return measures;
}

void store_subset_measures(Project& project, const std::vector<SubsetMeasure>& measures) {
  std::string text;
  for (const SubsetMeasure& each : measures)
    text += std::to_string(each.shapes) + ' ' + std::to_string(each.templates) + ' ' +
            number_text(each.learning_seconds) + ' ' + number_text(each.fitting_seconds) + ' ' +
            std::to_string(each.judging) + ' ' + share_text(each.accuracy.labelling) + ' ' +
            share_text(each.accuracy.best_labelling) + ' ' + share_text(each.accuracy.correspondence) + ' ' +
            to_text(each.truth) + '\n';
  project.set_setting(setting_key, text);
}

std::vector<SubsetMeasure> stored_subset_measures(const Project& project) {
  std::istringstream text(project.setting(setting_key).value_or(""));
  std::vector<SubsetMeasure> measures;
  for (std::string line; measures.size() < 1000 && std::getline(text, line);) {
    std::istringstream numbers(line);
    numbers.imbue(std::locale::classic());
    SubsetMeasure each;
    if (!(numbers >> each.shapes >> each.templates >> each.learning_seconds >> each.fitting_seconds)) break;
    // Earlier versions knew no accuracies, or not against what.
    double labelling = -1;
    double best = -1;
    double correspondence = -1;
    if (numbers >> each.judging >> labelling >> best >> correspondence)
      each.accuracy = {read_share(labelling), read_share(best), read_share(correspondence)};
    else
      each.judging = 0;
    std::string truth;
    if (std::getline(numbers, truth)) each.truth = ground_truth_from(truth);
    measures.push_back(each);
  }
  return measures;
}

}  // namespace archetype
