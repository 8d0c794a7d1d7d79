// Progress on standard error.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "core/base/job_control.h"

namespace archetype {

// One line that is written over and over when standard error is a terminal; otherwise a line now and then, if
// it takes that long. Cleared when it goes out of scope.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // For work that reports here. Valid as long as this object.
  JobControl control(std::stop_token stop);

 private:
  using Clock = std::chrono::steady_clock;
  void report(std::size_t done, std::size_t total, std::string_view what);

  std::mutex mutex_;
  bool terminal_;
  std::string what_;
  Clock::time_point begun_;  // of `what_`
  Clock::time_point next_;   // when to write again
  bool written_ = false;     // anything about `what`
  bool ended_ = false;       // that all of it is done
};

}  // namespace archetype
