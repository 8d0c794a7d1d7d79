// Segments, scores, joins and ranks.
#include "core/learning/initial_templates.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/fitting/fit_template.h"
#include "core/learning/mirror_symmetry.h"
#include "core/learning/template_from_boxes.h"

namespace archetype {

namespace {

class Search {
 public:
  Search(const InitialShapes& shapes, const InitialTemplateOptions& options, unsigned threads,
         const JobControl& control)
      : shapes_(shapes), options_(options), threads_(threads), control_(control) {
    stop_only_.stop = control.stop;
  }

  bool segment() {
    segmentations_.resize(shapes_.segmented.size());
    return parallel_for(segmentations_.size(), threads_, control_, "segmenting", [this](std::size_t i) {
      const std::optional<Segmentation> found =
          segment_shape(shapes_.samples[shapes_.segmented[i]], options_.segmentation, stop_only_);
      if (found) segmentations_[i] = *found;
    });
  }

  std::vector<PartTemplate> single_candidates() const {
    std::vector<PartTemplate> candidates;
    for (std::size_t i = 0; i < segmentations_.size(); ++i) {
      const std::size_t shape = shapes_.segmented[i];
      candidates.push_back(template_from_segmentation(segmentations_[i], shapes_.samples[shape]));
      candidates.back().name = "from " + shapes_.names[shape];
    }
    return candidates;
  }

  bool score(std::vector<PartTemplate> candidates) {
    const std::size_t each = shapes_.scored.size();
    std::vector<double> energies(candidates.size() * each);
    const bool all = parallel_for(energies.size(), threads_, control_, "scoring", [&](std::size_t i) {
      const std::optional<ShapeFit> fit =
          fit_template(candidates[i / each], shapes_.samples[shapes_.scored[i % each]], {}, stop_only_);
      if (fit) energies[i] = fit->energy.total();
    });
    if (!all || control_.cancelled()) return false;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      InitialTemplate result;
      for (std::size_t i = 0; i < each; ++i)
        result.mean_energy += energies[c * each + i] / static_cast<double>(each);
      result.score =
          result.mean_energy + options_.part_cost * static_cast<double>(candidates[c].parts.size());
      result.part_template = std::move(candidates[c]);
      ranked_.push_back(std::move(result));
    }
    std::ranges::stable_sort(ranked_, {}, &InitialTemplate::score);
    return true;
  }

  std::vector<InitialTemplate> best() {
    if (ranked_.size() > options_.candidates) ranked_.resize(options_.candidates);
    return std::move(ranked_);
  }

 private:
  const InitialShapes& shapes_;
  const InitialTemplateOptions& options_;
  unsigned threads_;
  const JobControl& control_;
  JobControl stop_only_;  // single fits do not report
  std::vector<Segmentation> segmentations_;
  std::vector<InitialTemplate> ranked_;
};

}  // namespace

std::optional<std::vector<InitialTemplate>> initial_templates(const InitialShapes& shapes,
                                                              const InitialTemplateOptions& options,
                                                              unsigned threads, const JobControl& control) {
  Search search(shapes, options, threads, control);
  if (!search.segment() || control.cancelled()) return std::nullopt;
  if (!search.score(search.single_candidates())) return std::nullopt;
  return search.best();
}

}  // namespace archetype
