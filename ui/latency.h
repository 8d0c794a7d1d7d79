// How long an edit takes until its fit is seen, measured inside the program.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
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
  void clear();
  const std::deque<double>& milliseconds() const { return milliseconds_; }
  // That all threads of the program worked, per frame since it was cleared: what the frames would take if
  // nothing else ran on the machine.
  double processor_milliseconds() const;

 private:
  std::deque<double> milliseconds_;
  std::clock_t cleared_ = std::clock();
  std::size_t frames_ = 0;
};

// How long a project took from the wish to open it until its shapes were on the screen.
class OpeningMeter {
 public:
  using Clock = std::chrono::steady_clock;

  void asked(Clock::time_point at) { asked_ = at; }
  void opened() { shown_next_ = asked_.has_value(); }  // the next frame shows it
  void frame_shown(Clock::time_point now);
  const std::optional<double>& milliseconds() const { return milliseconds_; }

 private:
  std::optional<Clock::time_point> asked_;
  bool shown_next_ = false;
  std::optional<double> milliseconds_;  // of the newest
};

// Bytes of memory that the program holds; nothing where the system does not tell.
std::optional<std::size_t> resident_memory();

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
