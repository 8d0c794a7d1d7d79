// Long work beside the window: it never waits for any of it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_control.h"

namespace archetype {

using JobId = std::uint64_t;

enum class JobState { running, paused, stopping, done, cancelled, failed };

// What a person sees of a job.
struct JobView {
  JobId id = 0;
  std::string title;
  std::string doing;                   // the step at hand, "" at first
  std::size_t done = 0;                // of total, in the job's own unit
  std::size_t total = 0;               // 0: not known yet
  double seconds = 0;                  // since the start, or from start to end; without the pauses
  std::optional<double> seconds_left;  // of the step at hand, once it can be told
  JobState state = JobState::running;
  std::string error;  // of a failed job: one line for a person

  bool active() const {
    return state == JobState::running || state == JobState::paused || state == JobState::stopping;
  }
};

// The time that the rest takes if it goes on as fast as the part that was done in `seconds`; nothing in the
// first second and while nothing is done.
std::optional<double> estimate_seconds_left(double seconds, std::size_t done, std::size_t total);

// Several jobs at once, a thread each. All members are for one thread, that of the window.
class Jobs {
 public:
  // Runs on the thread of the window once the work has ended; empty: nothing to apply.
  using Apply = std::function<void()>;
  // Runs on a thread of its own; holds its inputs by value. Checks control.stop at least every 50 ms. May
  // throw.
  using Work = std::function<Apply(const JobControl& control)>;

  // `wake` is called from other threads whenever poll() or view() has news. Thread-safe, quick.
  explicit Jobs(std::function<void()> wake = {});
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;
  ~Jobs();  // cancels all and waits for them

  JobId start(std::string title, Work work);
  void cancel(JobId id);
  void cancel_all();
  // A paused job sleeps at its next look at control, within what it takes to get there; it keeps its memory
  // and threads. Cancelled, it stops without going on.
  void pause(JobId id);
  void resume(JobId id);
  void pause_all();
  void resume_all();
  // Applies the results of the jobs that have ended, also of cancelled ones (they say what they kept).
  // Returns the views of those that ended since the last call.
  std::vector<JobView> poll();

  // Returns when no job works any more; what they made is still to be applied. Not while one is paused.
  void wait_for_work() const;
  bool idle() const { return running_.empty(); }
  bool resting() const;  // all that have not ended are paused
  // Running jobs in the order of their start, then the last ended ones, newest first. A job counts as running
  // until poll() has applied its result.
  std::vector<JobView> view() const;

 private:
  struct Running;
  std::function<void()> wake_;
  std::vector<std::unique_ptr<Running>> running_;
  std::vector<JobView> ended_;
  JobId next_id_ = 1;
};

}  // namespace archetype
