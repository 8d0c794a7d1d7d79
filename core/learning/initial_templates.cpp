// Segments, scores, joins and ranks.
#include "core/learning/initial_templates.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "core/base/parallel.h"
#include "core/fitting/fit_template.h"
#include "core/learning/mirror_symmetry.h"
#include "core/learning/recurring_parts.h"
#include "core/learning/template_from_boxes.h"

namespace archetype {

namespace {

constexpr std::size_t joined_bases = 3;  // candidates that get the parts of other shapes

// Boxes of near duplicates lie this near to each other, as a share of their size and in normalised units.
constexpr double duplicate_reach_share = 0.1;
constexpr double smallest_duplicate_reach = 0.05;

// Whether each part of one template has its own counterpart in the other, turned by quarters.
bool nearly_same_turned(const PartTemplate& a, const PartTemplate& b, int quarters) {
  if (a.parts.size() != b.parts.size()) return false;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-quarters * std::numbers::pi / 2, Vec3::UnitY()));
  std::vector<bool> taken(b.parts.size(), false);
  return std::ranges::all_of(a.parts, [&](const TemplatePart& part) {
    const Box box = with_nearest_axes({turn_quarters(part.position.mean, -quarters), part.scale.mean,
                                       (turn * part.orientation).normalized()});
    const double reach = smallest_duplicate_reach + duplicate_reach_share * box.half_extent.norm();
    for (std::size_t k = 0; k < taken.size(); ++k) {
      if (taken[k] || box_distance(box, b.parts[k].mean_box()) > reach) continue;
      taken[k] = true;
      return true;
    }
    return false;
  });
}

bool nearly_same(const PartTemplate& a, const PartTemplate& b) {
  for (int quarters = 0; quarters < 4; ++quarters) {
    if (nearly_same_turned(a, b, quarters)) return true;
  }
  return false;
}

// Existence becomes the share of the fits that have the part, but for parts that must exist.
void set_existence(PartTemplate& part_template, const std::vector<ShapeFit>& fits) {
  constexpr double least = 0.05;  // another shape may have what these lack
  for (std::size_t k = 0; k < part_template.parts.size(); ++k) {
    if (part_template.parts[k].must_exist) continue;
    const auto having =
        std::ranges::count_if(fits, [k](const ShapeFit& fit) { return fit.parts[k].present; });
    part_template.parts[k].existence =
        std::max(static_cast<double>(having) / static_cast<double>(fits.size()), least);
  }
}

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

  bool score_all(std::vector<PartTemplate> candidates) {
    for (PartTemplate& candidate : candidates) {
      std::optional<InitialTemplate> scored = score(std::move(candidate));
      if (!scored) return false;
      ranked_.push_back(std::move(*scored));
      control_.progress(ranked_.size(), candidates.size(), "scoring");
    }
    std::ranges::stable_sort(ranked_, {}, &InitialTemplate::score);
    return true;
  }

  // The best candidates so far, each with the parts of other shapes that lower its score.
  bool join() {
    std::vector<InitialTemplate> joined;
    const std::size_t bases = std::min(joined_bases, ranked_.size());
    control_.progress(0, bases, "joining");  // the first one takes its time: "scoring" is over
    for (std::size_t c = 0; c < bases; ++c) {
      std::optional<InitialTemplate> candidate = joined_from(ranked_[c].part_template);
      if (!candidate) return false;
      if (candidate->score < ranked_[c].score) joined.push_back(std::move(*candidate));
      control_.progress(c + 1, bases, "joining");
    }
    std::ranges::move(joined, std::back_inserter(ranked_));
    std::ranges::stable_sort(ranked_, {}, &InitialTemplate::score);
    return true;
  }

  // Without those that are nearly the same as a better one.
  std::vector<InitialTemplate> best() {
    std::vector<InitialTemplate> kept;
    for (InitialTemplate& candidate : ranked_) {
      if (kept.size() >= options_.candidates) break;
      const bool known = std::ranges::any_of(kept, [&](const InitialTemplate& better) {
        return nearly_same(candidate.part_template, better.part_template);
      });
      if (!known) kept.push_back(std::move(candidate));
    }
    return kept;
  }

 private:
  std::optional<std::vector<ShapeFit>> fit_all(const PartTemplate& part_template,
                                               const std::vector<std::size_t>& to) const {
    std::vector<ShapeFit> fits(to.size());
    parallel_for(to.size(), threads_, stop_only_, "fitting", [&](std::size_t i) {
      std::optional<ShapeFit> fit = fit_template(part_template, shapes_.samples[to[i]], {}, stop_only_);
      if (fit) fits[i] = std::move(*fit);
    });
    if (control_.cancelled()) return std::nullopt;
    return fits;
  }

  std::optional<InitialTemplate> score(PartTemplate candidate) const {
    const std::optional<std::vector<ShapeFit>> fits = fit_all(candidate, shapes_.scored);
    if (!fits) return std::nullopt;
    InitialTemplate result;
    // The part cost stands for the existence term, which would count every optional part twice.
    for (const ShapeFit& fit : *fits) result.mean_energy += fit.energy.total() - fit.energy.existence;
    result.mean_energy /= static_cast<double>(fits->size());
    result.score = result.mean_energy + options_.part_cost * static_cast<double>(candidate.parts.size());
    set_existence(candidate, *fits);
    result.part_template = std::move(candidate);
    return result;
  }

  // Takes all recurring parts, since those of one pair need each other, and gives up again each that does not
  // lower the score, the rarest first.
  std::optional<InitialTemplate> joined_from(const PartTemplate& base) const {
    const auto fits = fit_all(base, shapes_.segmented);
    if (!fits) return std::nullopt;
    std::vector<AlignedSegmentation> aligned;
    for (std::size_t i = 0; i < fits->size(); ++i) aligned.push_back({&segmentations_[i], &(*fits)[i]});
    PartTemplate joined = base;
    joined.name = "joined, " + base.name;
    std::ranges::move(recurring_parts(aligned, stop_only_), std::back_inserter(joined.parts));
    name_parts(joined);
    std::optional<InitialTemplate> best = score(std::move(joined));
    for (std::size_t k = best ? best->part_template.parts.size() : 0; k-- > base.parts.size();) {
      PartTemplate without = best->part_template;
      without.parts.erase(without.parts.begin() + static_cast<std::ptrdiff_t>(k));
      name_parts(without);
      std::optional<InitialTemplate> scored = score(std::move(without));
      if (!scored) return std::nullopt;
      if (scored->score <= best->score) best = std::move(scored);
    }
    return best;
  }

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
  if (!search.score_all(search.single_candidates())) return std::nullopt;
  if (!search.join()) return std::nullopt;
  return search.best();
}

}  // namespace archetype
