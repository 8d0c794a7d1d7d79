// The shapes of a collection by the template that explains them, with what lies outside apart.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/session/shape_columns.h"

namespace archetype {

enum class ClusterKind {
  members,   // of one template
  outliers,  // shapes that no template explains
  unfitted   // shapes without a fit
};

struct ShapeCluster {
  ClusterKind kind = ClusterKind::members;
  std::size_t part_template = 0;   // of members: an index into FitTable::templates
  std::vector<std::size_t> shown;  // rows, in the order that they were given in
  std::size_t all = 0;             // shapes, also those that are not shown
  std::size_t outliers = 0;        // of members: those of its template, which stand apart
  double mean_energy = 0;          // of all that have a finite one; 0 where none has
};

// The templates in use, also those without members, then others that fits still have; after them the outliers
// and the shapes without a fit, where there are any. `shown` holds rows in their order; outliers in the order
// by name come worst first.
std::vector<ShapeCluster> shape_clusters(const ShapeTable& shapes, std::span<const std::size_t> shown,
                                         bool by_name);

}  // namespace archetype
