// How long an edit takes until its fit is seen, measured inside the program.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace archetype {

// The value that `share` (0 to 1) of the values do not exceed; nothing while there is none.
std::optional<double> percentile(const std::deque<double>& values, double share);

// Milliseconds that frames took, from their beginning until they were on the screen: the last 1,000.
class FrameMeter {
 public:
  void shown(double milliseconds);
  void clear() { milliseconds_.clear(); }
  const std::deque<double>& milliseconds() const { return milliseconds_; }

 private:
  std::deque<double> milliseconds_;
};

// Every edit counts, also those that were never computed because a newer one came first: an edit is answered
// by the first displayed fit that is as new as it or newer.
class LatencyMeter {
 public:
  using Clock = std::chrono::steady_clock;

  void edited(std::uint64_t revision, Clock::time_point at);
  // A fit of the document at `revision` is on the screen now.
  void displayed(std::uint64_t revision, Clock::time_point at);
  void forget_open();  // edits that no fit will answer: the shape or template went
  void clear();

  const std::deque<double>& milliseconds() const { return answered_; }  // the last 1,000, oldest first
  std::optional<double> percentile(double share) const { return archetype::percentile(answered_, share); }

 private:
  struct Open {
    std::uint64_t revision;
    Clock::time_point at;
  };
  std::deque<Open> open_;
  std::deque<double> answered_;
};

}  // namespace archetype
