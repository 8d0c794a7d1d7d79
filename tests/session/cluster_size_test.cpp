#include "core/session/cluster_size.h"

#include <doctest/doctest.h>

#include "core/session/shape_clusters.h"

using namespace archetype;

TEST_CASE("Outliers are counted apart, and not at all where there are none") {
  CHECK(to_string(ClusterSize{}) == "0 shapes");
  CHECK(to_string(ClusterSize{1, 0}) == "1 shape");
  CHECK(to_string(ClusterSize{11, 1}) == "11 shapes, 1 outlier");
  CHECK(to_string(ClusterSize{1234567, 2000}) == "1,234,567 shapes, 2,000 outliers");
  ClusterSize size;
  for (const FitStatus status : {FitStatus::fitted, FitStatus::learned, FitStatus::outlier}) size.add(status);
  CHECK(size == ClusterSize{2, 1});
}
