#include "core/session/measure_subsets.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <numeric>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/random.h"

namespace archetype {
namespace {

constexpr const char* setting_key = "report.subsets";
constexpr std::size_t smallest_subset = 8;
constexpr std::size_t largest_subset = 1000;
constexpr std::uint64_t order_key = 0x5b5e;  // of the stream that orders the shapes

std::vector<ShapeId> in_random_order(std::vector<ShapeId> shapes, std::uint64_t seed) {
  RandomStream random(derive_seed(seed, order_key));
  for (std::size_t i = shapes.size(); i > 1; --i) std::swap(shapes[i - 1], shapes[random.below(i)]);
  return shapes;
}

}  // namespace

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
                                                          std::uint64_t seed, unsigned threads,
                                                          const JobControl& control) {
  const std::vector<ShapeId> shapes = in_random_order(project.shape_ids(), seed);
  std::vector<SubsetMeasure> measures;
  Project subset = Project::in_memory();
  std::size_t taken = 0;
  for (const std::size_t size : sizes) {
    for (; taken < std::min(size, shapes.size()); ++taken) {
      if (control.cancelled()) return std::nullopt;
      if (const auto record = project.find_shape(shapes[taken]))
        subset.add_shape(*record, project.samples(shapes[taken]));
    }
    const LearnReport report = learn_templates(subset, start, {}, {}, seed, true, threads, control);
    if (report.cancelled) return std::nullopt;
    measures.push_back({taken, subset.templates().size(), report.learning_seconds, report.fitting_seconds});
  }
  return measures;
}

void store_subset_measures(Project& project, const std::vector<SubsetMeasure>& measures) {
  std::string text;
  for (const SubsetMeasure& each : measures)
    text += std::to_string(each.shapes) + ' ' + std::to_string(each.templates) + ' ' +
            number_text(each.learning_seconds) + ' ' + number_text(each.fitting_seconds) + '\n';
  project.set_setting(setting_key, text);
}

std::vector<SubsetMeasure> stored_subset_measures(const Project& project) {
  std::istringstream text(project.setting(setting_key).value_or(""));
  text.imbue(std::locale::classic());
  std::vector<SubsetMeasure> measures;
  SubsetMeasure each;
  while (measures.size() < 1000 &&
         text >> each.shapes >> each.templates >> each.learning_seconds >> each.fitting_seconds)
    measures.push_back(each);
  return measures;
}

}  // namespace archetype
