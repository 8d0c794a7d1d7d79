// How far corresponding points lie from where they should (section 5, "Correspondence accuracy", figure 10).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace archetype {

// The share of correspondences within each distance. Errors are counted in steps, so that curves of millions
// of pairs take no memory and do not depend on the order in which they are added.
class ErrorCurve {
 public:
  static constexpr int steps = 50;
  static constexpr double step = 0.005;  // thresholds are 0, 0.005 … 0.25

  // error: a share of the size of the shape, >= 0. Infinite for a point that has found no counterpart.
  void add(double error);
  ErrorCurve& operator+=(const ErrorCurve& other);

  std::uint64_t count() const { return count_; }
  // Of all errors, those of at most `index * step`; 1 if there are none at all.
  double within(int index) const;
  friend bool operator==(const ErrorCurve&, const ErrorCurve&) = default;

 private:
  std::array<std::uint64_t, steps + 1> counts_{};  // by the smallest threshold that includes them
  std::uint64_t count_ = 0;
};

// Both customs: a share of the largest distance between two points of the target, and of the diagonal of its
// bounding box, which is easier.
struct CorrespondenceCurves {
  ErrorCurve by_diameter;
  ErrorCurve by_diagonal;

  CorrespondenceCurves& operator+=(const CorrespondenceCurves& other) {
    by_diameter += other.by_diameter;
    by_diagonal += other.by_diagonal;
    return *this;
  }
  friend bool operator==(const CorrespondenceCurves&, const CorrespondenceCurves&) = default;
};

}  // namespace archetype
