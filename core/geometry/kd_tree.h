// Nearest neighbours among points.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/vector.h"

namespace archetype {

// A k-d tree over points that the caller keeps alive and unchanged. Building costs O(n log n), a query O(log
// n). Ties are broken by the lower index, so that results do not depend on the order of the tree.
class KdTree {
 public:
  explicit KdTree(std::span<const Vec3> points);
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;
  ~KdTree();

  struct Neighbour {
    std::uint32_t index = 0;
    double squared_distance = 0;
  };

  // The tree must not be empty.
  Neighbour nearest(const Vec3& p) const;
  // At most k, nearest first, none farther than `reach`.
  void nearest(const Vec3& p, std::size_t k, std::vector<Neighbour>& result,
               double reach = std::numeric_limits<double>::infinity()) const;
  // The nearest point whose entry of `labels` is `label`; there must be one. `hint` is any point: the search
  // is short if it has the label and is close, as the answer of a similar question is.
  std::uint32_t nearest_labelled(const Vec3& p, std::span<const std::int16_t> labels, std::int16_t label,
                                 std::uint32_t hint) const;
  // All within `radius`, in no stated order.
  void within(const Vec3& p, double radius, std::vector<Neighbour>& result) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace archetype
