#include "core/session/shape_clusters.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace archetype {
namespace {

struct Sum {
  double energy = 0;
  std::size_t count = 0;
};

// The places of clusters: one per template, then the outliers and those without a fit.
class Places {
 public:
  explicit Places(const FitTable* table) {
    if (!table) return;
    for (std::size_t i = 0; i < table->templates.size(); ++i) of_template_[table->templates[i].id] = i;
    templates_ = table->templates.size();
  }

  std::size_t templates() const { return templates_; }
  std::size_t outliers() const { return templates_; }
  std::size_t unfitted() const { return templates_ + 1; }
  std::size_t count() const { return templates_ + 2; }
  // Nothing that a table in the making does not know yet is lost: it stands with those without a fit.
  std::size_t of(const ShapeRow& row) const {
    if (!row.fit) return unfitted();
    return row.fit->status == FitStatus::outlier ? outliers() : of_template(*row.fit);
  }
  std::size_t of_template(const FitSummary& fit) const {
    const auto found = of_template_.find(fit.part_template);
    return found == of_template_.end() ? unfitted() : found->second;
  }

 private:
  std::unordered_map<TemplateId, std::size_t> of_template_;
  std::size_t templates_ = 0;
};

}  // namespace

std::vector<ShapeCluster> shape_clusters(const ShapeTable& shapes, std::span<const std::size_t> shown,
                                         bool by_name) {
  const Places places(shapes.fits());
  std::vector<ShapeCluster> clusters(places.count());
  std::vector<Sum> sums(places.count());
  for (const ShapeRow& row : shapes.rows()) {
    const std::size_t place = places.of(row);
    ++clusters[place].all;
    if (place == places.outliers()) ++clusters[places.of_template(*row.fit)].outliers;
    if (!row.fit || !std::isfinite(row.fit->energy.total())) continue;
    sums[place].energy += row.fit->energy.total();
    ++sums[place].count;
  }
  for (const std::size_t row : shown) clusters[places.of(shapes.rows()[row])].shown.push_back(row);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    clusters[i].part_template = i;
    if (sums[i].count > 0) clusters[i].mean_energy = sums[i].energy / static_cast<double>(sums[i].count);
  }
  clusters[places.outliers()].kind = ClusterKind::outliers;
  clusters[places.unfitted()].kind = ClusterKind::unfitted;
  if (by_name)
    std::ranges::stable_sort(clusters[places.outliers()].shown, std::greater(), [&](std::size_t row) {
      const double energy = shapes.rows()[row].fit->energy.total();
      return std::isfinite(energy) ? energy : HUGE_VAL;
    });
  std::erase_if(clusters, [&](const ShapeCluster& cluster) {
    const bool kept =
        cluster.kind == ClusterKind::members && shapes.fits()->templates[cluster.part_template].current;
    return cluster.all == 0 && !kept;
  });
  return clusters;
}

}  // namespace archetype
