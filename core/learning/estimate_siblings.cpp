// The common spreads are those of a template whose shapes were all moved to its middle.
#include "core/learning/estimate_siblings.h"

#include <algorithm>
#include <utility>

namespace archetype {

namespace {

using Observed = std::vector<std::vector<PartObservation>>;

// Each part about its mean over the shapes that have it.
Observed centred(Observed shapes) {
  for (std::size_t k = 0; !shapes.empty() && k < shapes.front().size(); ++k) {
    Vec3 centre = Vec3::Zero();
    Vec3 half_extent = Vec3::Zero();
    double having = 0;
    for (const auto& parts : shapes) {
      if (!parts[k].present) continue;
      centre += parts[k].box.centre;
      half_extent += parts[k].box.half_extent;
      having += 1;
    }
    for (auto& parts : shapes) {
      PartObservation& part = parts[k];
      if (!part.present) continue;
      part.box.centre -= centre / having;
      part.box.half_extent -= half_extent / having;
    }
  }
  return shapes;
}

// About nothing, and as wide as any of these was known to be. Only its spreads are of use.
PartTemplate widest(const std::vector<const LearnedTemplate*>& siblings) {
  PartTemplate result = siblings.front()->initial;
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    TemplatePart& part = result.parts[k];
    part.position.mean.setZero();
    part.scale.mean.setZero();
    part.has_features = true;  // none are to be expected of boxes without a size
    for (const LearnedTemplate* each : siblings) {
      const TemplatePart& known = each->initial.parts[k];
      part.position.stddev = part.position.stddev.cwiseMax(known.position.stddev);
      part.scale.stddev = part.scale.stddev.cwiseMax(known.scale.stddev);
    }
  }
  return result;
}

}  // namespace

bool are_siblings(const PartTemplate& a, const PartTemplate& b) {
  return std::ranges::equal(a.parts, b.parts, [](const TemplatePart& x, const TemplatePart& y) {
    return x.name == y.name && x.label == y.label;
  });
}

std::vector<LearnedTemplate> estimate_siblings(std::span<const LearnedTemplate> siblings,
                                               std::span<const Observed> observed,
                                               const LearnOptions& options) {
  std::vector<LearnedTemplate> result(siblings.begin(), siblings.end());
  std::vector<const LearnedTemplate*> taught;
  Observed all;
  for (std::size_t t = 0; t < siblings.size(); ++t) {
    if (observed[t].size() < options.smallest_learning_set) continue;
    taught.push_back(&siblings[t]);
    for (auto& shape : centred(observed[t])) all.push_back(std::move(shape));
  }
  if (taught.empty()) return result;
  const PartTemplate common = reestimate(widest(taught), all, options);
  for (std::size_t t = 0; t < siblings.size(); ++t) {
    if (observed[t].size() < options.smallest_learning_set) continue;
    LearnedTemplate& each = result[t];
    const PartTemplate alone = reestimate(each.initial, observed[t], options);
    for (std::size_t k = 0; k < common.parts.size(); ++k) {
      TemplatePart& known = each.initial.parts[k];
      known.position = {alone.parts[k].position.mean, common.parts[k].position.stddev};
      known.scale = {alone.parts[k].scale.mean, common.parts[k].scale.stddev};
    }
    each.part_template = reestimate(each.initial, observed[t], options);
    each.undivided.clear();
  }
  return result;
}

}  // namespace archetype
