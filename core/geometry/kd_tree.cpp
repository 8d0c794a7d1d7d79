// The one place where nanoflann shows. Its radii are squared.
#include "core/geometry/kd_tree.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

namespace archetype {

namespace {

struct Adaptor {
  std::span<const Vec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor, 3,
                                                 std::uint32_t>;

// nanoflann skips what is not below its bound: just above it equal distances stay in play.
double just_above(double d) {
  return std::nextafter(d, std::numeric_limits<double>::infinity());
}

// Keeps the k best with ties broken by index; nanoflann's own result sets break them by the order of visits.
class BestK {
 public:
  using DistanceType = double;
  BestK(std::size_t k, double squared_reach, std::vector<KdTree::Neighbour>& best)
      : k_(k), limit_(just_above(squared_reach)), best_(best) {
    best_.clear();
  }
  std::size_t size() const { return best_.size(); }
  bool full() const { return best_.size() == k_; }
  double worstDist() const { return limit_; }  // NOLINT(readability-identifier-naming): nanoflann's name
  bool addPoint(double distance, std::uint32_t index) {  // NOLINT(readability-identifier-naming)
    const KdTree::Neighbour entry{index, distance};
    if (full()) {
      if (!before(entry, best_.back())) return true;
      best_.pop_back();
    }
    best_.insert(std::upper_bound(best_.begin(), best_.end(), entry, before), entry);
    if (full()) limit_ = just_above(best_.back().squared_distance);
    return true;
  }

 private:
  static bool before(const KdTree::Neighbour& a, const KdTree::Neighbour& b) {
    return a.squared_distance < b.squared_distance ||
           (a.squared_distance == b.squared_distance && a.index < b.index);
  }
  std::size_t k_;
  double limit_;
  std::vector<KdTree::Neighbour>& best_;
};

class Within {
 public:
  using DistanceType = double;
  Within(double squared, std::vector<KdTree::Neighbour>& found)
      : squared_(squared), limit_(just_above(squared)), found_(found) {
    found_.clear();
  }
  std::size_t size() const { return found_.size(); }
  bool full() const { return true; }
  double worstDist() const { return limit_; }            // NOLINT(readability-identifier-naming)
  bool addPoint(double distance, std::uint32_t index) {  // NOLINT(readability-identifier-naming)
    if (distance <= squared_) found_.push_back({index, distance});
    return true;
  }

 private:
  double squared_;
  double limit_;
  std::vector<KdTree::Neighbour>& found_;
};

class NearestLabelled {
 public:
  using DistanceType = double;
  NearestLabelled(std::span<const std::int16_t> labels, std::int16_t label, double limit, std::uint32_t index)
      : labels_(labels), label_(label), best_(limit), limit_(just_above(limit)), index_(index) {}
  std::size_t size() const { return 1; }
  bool full() const { return true; }
  double worstDist() const { return limit_; }            // NOLINT(readability-identifier-naming)
  bool addPoint(double distance, std::uint32_t index) {  // NOLINT(readability-identifier-naming)
    if (labels_[index] != label_ || distance > best_ || (distance == best_ && index >= index_)) return true;
    best_ = distance;
    limit_ = just_above(distance);
    index_ = index;
    return true;
  }
  std::uint32_t index() const { return index_; }

 private:
  std::span<const std::int16_t> labels_;
  std::int16_t label_;
  double best_;
  double limit_;
  std::uint32_t index_;
};

constexpr std::size_t leaf_size = 16;

}  // namespace

struct KdTree::Index {
  explicit Index(std::span<const Vec3> points)
      : adaptor{points}, tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)) {}
  Adaptor adaptor;
  Tree tree;
};

KdTree::KdTree(std::span<const Vec3> points) : index_(std::make_unique<Index>(points)) {}
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;
KdTree::~KdTree() = default;

KdTree::Neighbour KdTree::nearest(const Vec3& p) const {
  std::vector<Neighbour> best;
  best.reserve(2);
  nearest(p, 1, best);
  return best.front();
}

void KdTree::nearest(const Vec3& p, std::size_t k, std::vector<Neighbour>& result, double reach) const {
  BestK best(k, reach * reach, result);
  if (k > 0) index_->tree.findNeighbors(best, p.data(), nanoflann::SearchParams());
}

std::uint32_t KdTree::nearest_labelled(const Vec3& p, std::span<const std::int16_t> labels,
                                       std::int16_t label, std::uint32_t hint) const {
  const bool known = labels[hint] == label;
  const double limit =
      known ? (index_->adaptor.points[hint] - p).squaredNorm() : std::numeric_limits<double>::infinity();
  NearestLabelled best(labels, label, limit, known ? hint : UINT32_MAX);
  index_->tree.findNeighbors(best, p.data(), nanoflann::SearchParams());
  return best.index();
}

void KdTree::within(const Vec3& p, double radius, std::vector<Neighbour>& result) const {
  Within found(radius * radius, result);
  index_->tree.findNeighbors(found, p.data(), nanoflann::SearchParams());
}

}  // namespace archetype
