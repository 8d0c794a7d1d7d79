// Segments, scores, joins and ranks.
#include "core/learning/initial_templates.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numbers>

#include "core/base/parallel.h"
#include "core/fitting/fit_template.h"
#include "core/learning/learn_options.h"
#include "core/learning/mirror_symmetry.h"
#include "core/learning/recurring_parts.h"
#include "core/learning/reestimate.h"
#include "core/learning/template_from_boxes.h"

namespace archetype {

namespace {

constexpr std::size_t ways = 2;          // to segment shapes: into boxes, and with round parts
constexpr std::size_t joined_bases = 2;  // candidates of each that get the parts of other shapes

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

// How shapes are segmented, and the candidates that come of it, the best first.
struct Way {
  RegionSolids solids;
  const char* prefix;                       // of the names of the candidates
  std::vector<Segmentation> segmentations;  // one per segmented shape
  std::vector<InitialTemplate> ranked = {};
};

class Search {
 public:
  Search(const InitialShapes& shapes, const InitialTemplateOptions& options, unsigned threads,
         const JobControl& control)
      : shapes_(shapes), options_(options), threads_(threads), control_(control) {
    stop_only_.stop = control.stop;
  }

  bool segment() {
    for (Way& way : ways_) way.segmentations.resize(shapes_.segmented.size());
    const std::size_t count = ways_.size() * shapes_.segmented.size();
    return parallel_for(count, threads_, control_, "segmenting", [this](std::size_t i) {
      Way& way = ways_[i % ways_.size()];
      SegmentationOptions options = options_.segmentation;
      options.solids = way.solids;
      const std::size_t k = i / ways_.size();
      auto found = segment_shape(shapes_.samples[shapes_.segmented[k]], options, stop_only_);
      if (found) way.segmentations[k] = *std::move(found);
    });
  }

  bool score_all() {
    const std::size_t count = ways_.size() * shapes_.segmented.size();
    std::size_t done = 0;
    for (Way& way : ways_) {
      for (std::size_t k = 0; k < shapes_.segmented.size(); ++k) {
        if (!is_as_before(way, k)) {
          const std::size_t shape = shapes_.segmented[k];
          PartTemplate candidate = template_from_segmentation(way.segmentations[k], shapes_.samples[shape]);
          candidate.name = way.prefix + ("from " + shapes_.names[shape]);
          std::optional<Scored> scored = score(std::move(candidate));
          if (!scored) return false;
          way.ranked.push_back(std::move(scored->candidate));
        }
        control_.progress(++done, count, "scoring");
      }
      std::ranges::stable_sort(way.ranked, {}, &InitialTemplate::score);
    }
    return true;
  }

  // The best candidates so far, each with the parts of other shapes that are worth their price.
  bool join() {
    const auto bases_of = [](const Way& way) { return std::min(joined_bases, way.ranked.size()); };
    std::size_t count = 0;
    for (const Way& way : ways_) count += bases_of(way);
    control_.progress(0, count, "joining");  // the first one takes its time: "scoring" is over
    std::size_t done = 0;
    for (Way& way : ways_) {
      std::vector<InitialTemplate> joined;
      for (std::size_t c = 0; c < bases_of(way); ++c) {
        std::optional<InitialTemplate> candidate =
            joined_from(way.ranked[c].part_template, way.segmentations);
        if (!candidate) return false;
        const bool has_more =
            candidate->part_template.parts.size() > way.ranked[c].part_template.parts.size();
        if (has_more && with_price(*candidate) < with_price(way.ranked[c]))
          joined.push_back(std::move(*candidate));
        control_.progress(++done, count, "joining");
      }
      std::ranges::move(joined, std::back_inserter(way.ranked));
      std::ranges::stable_sort(way.ranked, {}, &InitialTemplate::score);
    }
    return true;
  }

  // As many of each way as there are, the way of the best one first, and where one has fewer, more of the
  // other: how well learning will do with a candidate shows only when it is tried. Of those that are nearly
  // the same, the best.
  std::vector<InitialTemplate> best() {
    std::vector<InitialTemplate> kept;
    std::ranges::stable_sort(ways_, {}, [](const Way& way) {
      return way.ranked.empty() ? std::numeric_limits<double>::infinity() : way.ranked.front().score;
    });
    std::array<std::size_t, ways> next{};
    const auto take_from = [&](std::size_t w) {
      while (next[w] < ways_[w].ranked.size()) {
        InitialTemplate& candidate = ways_[w].ranked[next[w]++];
        const auto known = std::ranges::find_if(kept, [&](const InitialTemplate& other) {
          return nearly_same(candidate.part_template, other.part_template);
        });
        if (known == kept.end()) {
          kept.push_back(std::move(candidate));
          return true;
        }
        if (candidate.score < known->score) *known = std::move(candidate);
      }
      return false;
    };
    for (bool taken = true; taken;) {
      taken = false;
      for (std::size_t w = 0; w < ways && kept.size() < options_.candidates; ++w)
        taken = take_from(w) || taken;
    }
    std::ranges::stable_sort(kept, {}, &InitialTemplate::score);
    return kept;
  }

 private:
  // yaws: by shape; where there are none, all four are tried.
  std::optional<std::vector<ShapeFit>> fit_all(const PartTemplate& part_template,
                                               const std::vector<std::size_t>& to,
                                               const std::vector<int>& yaws = {}) const {
    std::vector<ShapeFit> fits(to.size());
    parallel_for(to.size(), threads_, stop_only_, "fitting", [&](std::size_t i) {
      FitOptions options;
      if (!yaws.empty()) {
        options.yaw_costs.fill(std::numeric_limits<double>::infinity());
        options.yaw_costs[static_cast<std::size_t>(yaws[i])] = 0;
      }
      std::optional<ShapeFit> fit = fit_template(part_template, shapes_.samples[to[i]], options, stop_only_);
      if (fit) fits[i] = std::move(*fit);
    });
    if (control_.cancelled()) return std::nullopt;
    return fits;
  }

  // A candidate, and the yaws that the scored shapes took with it.
  struct Scored {
    InitialTemplate candidate;
    std::vector<int> yaws;
  };

  // known_yaws: by scored shape; where there are none, all four are tried.
  std::optional<Scored> score(PartTemplate candidate, const std::vector<int>& known_yaws = {}) const {
    const auto fits = fit_all(candidate, shapes_.scored, known_yaws);
    if (!fits) return std::nullopt;
    InitialTemplate result;
    std::vector<std::vector<PartObservation>> observed;
    std::vector<int> yaws;
    for (std::size_t i = 0; i < fits->size(); ++i) {
      const ShapeFit& fit = (*fits)[i];
      result.mean_energy += (fit.energy.total() - fit.energy.existence) / static_cast<double>(fits->size());
      observed.push_back(observe_parts(fit, shapes_.samples[shapes_.scored[i]]));
      yaws.push_back(fit.yaw_quarters);
    }
    const auto bent = fit_all(reestimate(candidate, observed, {}), shapes_.scored, yaws);
    if (!bent) return std::nullopt;
    for (const ShapeFit& fit : *bent) {
      const auto present = std::ranges::count(fit.parts, true, &FittedPart::present);
      result.score +=
          start_score(fit.energy.data(), static_cast<double>(present)) / static_cast<double>(bent->size());
    }
    set_existence(candidate, *fits);
    result.part_template = std::move(candidate);
    return Scored{std::move(result), std::move(yaws)};
  }

  // Whether the first way has cut the shape in the same places. What is round then reaches a little less far,
  // which is the first thing that estimates mend.
  bool is_as_before(const Way& way, std::size_t k) const {
    return &way != ways_.data() && way.segmentations[k].labels == ways_.front().segmentations[k].labels;
  }

  double with_price(const InitialTemplate& candidate) const {
    return candidate.score + options_.part_cost * static_cast<double>(candidate.part_template.parts.size());
  }

  // Takes all recurring parts, since those of one pair need each other, and gives up again those that hardly
  // any fit has, all at once, and then each that is not worth its price, the rarest first. For these the yaws
  // stay those that the shapes have taken.
  std::optional<InitialTemplate> joined_from(const PartTemplate& base,
                                             const std::vector<Segmentation>& segmentations) const {
    const auto fits = fit_all(base, shapes_.segmented);
    if (!fits) return std::nullopt;
    std::vector<AlignedSegmentation> aligned;
    for (std::size_t i = 0; i < fits->size(); ++i) aligned.push_back({&segmentations[i], &(*fits)[i]});
    PartTemplate joined = base;
    joined.name = "joined, " + base.name;
    std::ranges::move(recurring_parts(aligned, stop_only_), std::back_inserter(joined.parts));
    name_parts(joined);
    std::optional<Scored> scored = score(joined);
    if (!scored) return std::nullopt;
    Scored best = std::move(*scored);
    for (std::size_t k = joined.parts.size(); k-- > base.parts.size();) {
      if (best.candidate.part_template.parts[k].existence < smallest_recurrence)
        joined.parts.erase(joined.parts.begin() + static_cast<std::ptrdiff_t>(k));
    }
    if (joined.parts.size() < best.candidate.part_template.parts.size()) {
      name_parts(joined);
      scored = score(std::move(joined));
      if (!scored) return std::nullopt;
      if (with_price(scored->candidate) <= with_price(best.candidate)) best = std::move(*scored);
    }
    for (std::size_t k = best.candidate.part_template.parts.size(); k-- > base.parts.size();) {
      PartTemplate without = best.candidate.part_template;
      without.parts.erase(without.parts.begin() + static_cast<std::ptrdiff_t>(k));
      name_parts(without);
      scored = score(std::move(without), best.yaws);
      if (!scored) return std::nullopt;
      if (with_price(scored->candidate) <= with_price(best.candidate)) best = std::move(*scored);
    }
    return std::move(best.candidate);
  }

  const InitialShapes& shapes_;
  const InitialTemplateOptions& options_;
  unsigned threads_;
  const JobControl& control_;
  JobControl stop_only_;  // single fits do not report
  std::array<Way, ways> ways_{Way{RegionSolids::boxes, "", {}}, Way{RegionSolids::any, "rounded, ", {}}};
};

}  // namespace

double start_score(double misfit, double parts) {
  constexpr double of_a_part = 0.001;
  return misfit - of_a_part * parts;
}

std::optional<std::vector<InitialTemplate>> initial_templates(const InitialShapes& shapes,
                                                              const InitialTemplateOptions& options,
                                                              unsigned threads, const JobControl& control) {
  Search search(shapes, options, threads, control);
  if (!search.segment() || control.cancelled()) return std::nullopt;
  if (!search.score_all() || !search.join()) return std::nullopt;
  return search.best();
}

}  // namespace archetype
