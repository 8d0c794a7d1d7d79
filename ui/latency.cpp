#include "ui/latency.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

namespace archetype {
namespace {

constexpr std::size_t kept = 1000;

}  // namespace

std::optional<double> percentile(const std::deque<double>& values, double share) {
  if (values.empty()) return std::nullopt;
  std::vector<double> sorted(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(sorted.size())) - 1;
  const auto index =
      static_cast<std::ptrdiff_t>(std::clamp(rank, 0.0, static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + index, sorted.end());
  return sorted[static_cast<std::size_t>(index)];
}

void FrameMeter::shown(double milliseconds) {
  milliseconds_.push_back(milliseconds);
  ++frames_;
  if (milliseconds_.size() > kept) milliseconds_.pop_front();
}

void FrameMeter::clear() {
  *this = FrameMeter();
}

double FrameMeter::processor_milliseconds() const {
  const auto worked = static_cast<double>(std::clock() - cleared_);
  return frames_ == 0 ? 0 : 1000 * worked / CLOCKS_PER_SEC / static_cast<double>(frames_);
}

void OpeningMeter::frame_shown(Clock::time_point now) {
  if (!std::exchange(shown_next_, false)) return;
  milliseconds_ =
      std::chrono::duration<double, std::milli>(now - *std::exchange(asked_, std::nullopt)).count();
}

std::optional<std::size_t> resident_memory() {
  std::ifstream pages("/proc/self/statm");  // Linux
  std::size_t all = 0;
  std::size_t resident = 0;
  if (!(pages >> all >> resident)) return std::nullopt;
  constexpr std::size_t page = 4096;
  return resident * page;
}

void LatencyMeter::edited(std::uint64_t revision, Clock::time_point at) {
  constexpr std::size_t most_open = 10'000;  // nothing answers them: no shape is in view
  open_.push_back({revision, at});
  if (open_.size() > most_open) open_.pop_front();
}

void LatencyMeter::displayed(std::uint64_t revision, Clock::time_point at) {
  while (!open_.empty() && open_.front().revision <= revision) {
    answered_.push_back(std::chrono::duration<double, std::milli>(at - open_.front().at).count());
    open_.pop_front();
    if (answered_.size() > kept) answered_.pop_front();
  }
}

void LatencyMeter::forget_open() {
  open_.clear();
}

void LatencyMeter::clear() {
  open_.clear();
  answered_.clear();
}

}  // namespace archetype
