// When shapes that are done go into the project.
#pragma once

#include <chrono>

#include "core/base/job_control.h"

namespace archetype {

// In batches, since every commit waits for the disk; but a run that is stopped or paused, or cut off at any
// moment, loses no more than a second's work.
class CommitPace {
 public:
  bool due(std::size_t pending, const JobControl& control) const {
    constexpr std::size_t batch = 16;
    constexpr std::chrono::seconds longest{1};
    return pending >= batch ||
           (pending > 0 && (control.stop.paused() || control.cancelled() || Clock::now() - last_ >= longest));
  }
  void committed() { last_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace archetype
