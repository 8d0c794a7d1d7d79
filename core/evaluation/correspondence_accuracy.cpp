// Counts.
#include "core/evaluation/correspondence_accuracy.h"

#include <cmath>

#include "core/base/error.h"

namespace archetype {

void ErrorCurve::add(double error) {
  if (!(error >= 0)) throw PreconditionError("an error of a correspondence is negative or no number");
  ++count_;
  // Errors that are a threshold but for rounding belong to it.
  const double place = std::ceil(error / step - 1e-9);
  if (place <= steps) ++counts_[static_cast<std::size_t>(place)];
}

ErrorCurve& ErrorCurve::operator+=(const ErrorCurve& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  count_ += other.count_;
  return *this;
}

double ErrorCurve::within(int index) const {
  if (count_ == 0) return 1;
  std::uint64_t sum = 0;
  for (int i = 0; i <= index; ++i) sum += counts_.at(static_cast<std::size_t>(i));
  return static_cast<double>(sum) / static_cast<double>(count_);
}

}  // namespace archetype
