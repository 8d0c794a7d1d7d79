// Sums overlaps of parts and ground truth into accuracies and confusion tables.
#include "core/evaluation/labelling_accuracy.h"

#include "core/base/error.h"

namespace archetype {

namespace {

// Right and all of one shape or of several.
struct Tally {
  ElementShare right;
  ElementShare all;

  void add(const ElementShare& share, bool is_right) {
    all += share;
    if (is_right) right += share;
  }
  LabellingAccuracy accuracy() const {
    return {all.area > 0 ? right.area / all.area : 1, all.count > 0 ? right.count / all.count : 1};
  }
};

// What each part is called under one assignment; nothing at all in no part.
int label_of(int part, std::span<const int> labels) {
  return part < 0 ? -1 : labels[static_cast<std::size_t>(part)];
}

std::vector<int> assign_best(std::span<const ShapeOverlap> shapes, std::size_t part_count) {
  PartOverlap sum;
  for (const ShapeOverlap& shape : shapes) {
    for (const auto& [pair, share] : shape.overlap) sum[pair] += share;
  }
  std::vector<int> labels(part_count, -1);
  std::vector<double> most(part_count, 0);
  for (const auto& [pair, share] : sum) {
    const auto [part, truth] = pair;
    if (part < 0) continue;
    const auto p = static_cast<std::size_t>(part);
    if (labels[p] < 0 || share.area > most[p]) {
      labels[p] = truth;
      most[p] = share.area;
    }
  }
  return labels;
}

void add_mean(LabellingAccuracy& mean, const LabellingAccuracy& value, double weight) {
  mean.by_area += weight * value.by_area;
  mean.by_count += weight * value.by_count;
}

}  // namespace

PartOverlap measure_overlap(std::span<const int> parts, std::span<const int> truth,
                            std::span<const double> areas) {
  if (parts.size() != truth.size() || parts.size() != areas.size()) {
    throw PreconditionError("measure_overlap needs a part, a label and an area per element");
  }
  PartOverlap overlap;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (truth[i] >= 0) overlap[{parts[i], truth[i]}] += {areas[i], 1};
  }
  return overlap;
}

LabellingReport measure_labelling(std::span<const ShapeOverlap> shapes, std::span<const int> own_labels) {
  LabellingReport report;
  report.mean.name = "mean";
  report.total.name = "total";
  report.best_labels = assign_best(shapes, own_labels.size());
  Tally own_total;
  Tally best_total;
  for (const ShapeOverlap& shape : shapes) {
    Tally own;
    Tally best;
    for (const auto& [pair, share] : shape.overlap) {
      const auto [part, truth] = pair;
      const int own_label = label_of(part, own_labels);
      const int best_label = label_of(part, report.best_labels);
      // Truth is never negative here, so no part and a part with a negative label are wrong everywhere.
      own.add(share, own_label == truth);
      best.add(share, best_label == truth);
      own_total.add(share, own_label == truth);
      best_total.add(share, best_label == truth);
      report.own_confusion[{own_label, truth}] += share;
      report.best_confusion[{best_label, truth}] += share;
      report.part_confusion[pair] += share;
    }
    report.shapes.push_back({shape.name, own.accuracy(), best.accuracy()});
    const double weight = 1.0 / static_cast<double>(shapes.size());
    add_mean(report.mean.own, own.accuracy(), weight);
    add_mean(report.mean.best, best.accuracy(), weight);
  }
  report.total.own = own_total.accuracy();
  report.total.best = best_total.accuracy();
  return report;
}

}  // namespace archetype
