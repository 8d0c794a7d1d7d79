// How many shapes a template has, and how that is said: the same in every view, figure and report.
#pragma once

#include <string>

#include "core/io/project.h"

namespace archetype {

// The shapes of a cluster are those that its template explains; outliers, which no template does, are counted
// apart, with the template that fits them least badly.
struct ClusterSize {
  std::size_t shapes = 0;
  std::size_t outliers = 0;

  void add(FitStatus status) { ++(status == FitStatus::outlier ? outliers : shapes); }
  friend bool operator==(const ClusterSize&, const ClusterSize&) = default;
};

// "1,204 shapes", "11 shapes, 1 outlier".
std::string to_string(const ClusterSize& size);

}  // namespace archetype
