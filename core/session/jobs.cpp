#include "core/session/jobs.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/priority.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t ended_kept = 20;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

// The time that work takes, without its pauses.
class WorkClock {
 public:
  double seconds() const { return before_ + (since_ ? seconds_between(*since_, Clock::now()) : 0); }
  void halt() {
    before_ = seconds();
    since_.reset();
  }
  void go_on() {
    if (!since_) since_ = Clock::now();
  }

 private:
  double before_ = 0;
  std::optional<Clock::time_point> since_ = Clock::now();  // nothing: it stands
};

}  // namespace

std::optional<double> estimate_seconds_left(double seconds, std::size_t done, std::size_t total) {
  if (seconds < 1.0 || done == 0 || total == 0) return std::nullopt;
  const std::size_t rest = total > done ? total - done : 0;
  return seconds * static_cast<double>(rest) / static_cast<double>(done);
}

struct Jobs::Running {
  JobId id = 0;
  std::string title;
  std::stop_source stop;
  std::shared_ptr<PauseGate> gate = std::make_shared<PauseGate>();

  std::mutex mutex;  // guards the seven below
  WorkClock clock;
  double step_start = 0;  // by that clock
  std::string doing;
  std::size_t done = 0;
  std::size_t total = 0;
  Clock::time_point last_wake{};

  std::atomic<bool> ended = false;
  Apply apply;  // the three are written before `ended` is set, read after
  std::string error;
  bool failed = false;

  std::jthread thread;  // last: it is joined before the rest goes

  // What has ended is still shown as running until its result is applied: nobody sees a gap between the two
  // in which it is neither under way nor done.
  JobView view(bool applied = false) {
    JobView view;
    view.id = id;
    view.title = title;
    bool over = false;
    {
      const std::lock_guard lock(mutex);
      view.doing = doing;
      view.done = done;
      view.total = total;
      over = ended;
      view.seconds = clock.seconds();
      view.seconds_left = estimate_seconds_left(view.seconds - step_start, done, total);
    }
    view.error = applied ? error : "";
    const bool stopping = stop.stop_requested();
    const bool paused = !over && gate->closed();
    if (!applied)
      view.state = stopping ? JobState::stopping : paused ? JobState::paused : JobState::running;
    else
      view.state = failed ? JobState::failed : stopping ? JobState::cancelled : JobState::done;
    return view;
  }

  // Ten times a second are enough for a progress bar, and cost nothing.
  void report(std::size_t now_done, std::size_t now_total, std::string_view what,
              const std::function<void()>& wake) {
    bool tell = false;
    {
      const std::lock_guard lock(mutex);
      // Threads report out of order; within one step the count only rises, until it is through. Its total may
      // change on the way: what was done till then was done in this step all the same.
      const bool same_count = what == doing && now_total == total && done < total;
      const bool same_step = same_count || (what == doing && now_done >= done);
      if (!same_step) step_start = clock.seconds();
      done = same_count ? std::max(done, now_done) : now_done;
      doing = what;
      total = now_total;
      const Clock::time_point now = Clock::now();
      if (seconds_between(last_wake, now) > 0.1) {
        last_wake = now;
        tell = true;
      }
    }
    if (tell && wake) wake();
  }

  void finish() {
    const std::lock_guard lock(mutex);
    clock.halt();
    ended = true;
    ended.notify_all();
  }

  void pause(bool wanted) {
    const std::lock_guard lock(mutex);
    if (ended) return;
    if (wanted) {
      gate->close();
      clock.halt();
    } else {
      clock.go_on();
      gate->open();
    }
  }
};

Jobs::Jobs(std::function<void()> wake) : wake_(std::move(wake)) {}

Jobs::~Jobs() {
  cancel_all();
}

JobId Jobs::start(std::string title, Work work) {
  auto job = std::make_unique<Running>();
  Running* running = job.get();
  running->id = next_id_++;
  running->title = std::move(title);
  running->thread = std::jthread([running, work = std::move(work), wake = wake_]() mutable {
    lower_priority(Priority::job);
    JobControl control;
    control.stop = {running->stop.get_token(), running->gate};
    control.report = [running, &wake](std::size_t done, std::size_t total, std::string_view what) {
      running->report(done, total, what, wake);
    };
    try {
      running->apply = work(control);
    } catch (const std::exception& error) {
      running->error = error.what();
      running->failed = true;
    }
    work = nullptr;  // who sees the end may join the thread: what it holds is let go of before
    running->finish();
    if (wake) wake();
  });
  running_.push_back(std::move(job));
  return running->id;
}

void Jobs::cancel(JobId id) {
  for (const auto& job : running_)
    if (job->id == id) job->stop.request_stop();
}

void Jobs::cancel_all() {
  for (const auto& job : running_) job->stop.request_stop();
}

void Jobs::pause(JobId id) {
  for (const auto& job : running_)
    if (job->id == id) job->pause(true);
}

void Jobs::resume(JobId id) {
  for (const auto& job : running_)
    if (job->id == id) job->pause(false);
}

void Jobs::pause_all() {
  for (const auto& job : running_) job->pause(true);
}

void Jobs::resume_all() {
  for (const auto& job : running_) job->pause(false);
}

bool Jobs::resting() const {
  return std::ranges::all_of(running_, [](const auto& job) { return job->view().state == JobState::paused; });
}

std::vector<JobView> Jobs::poll() {
  // Taken out first: what is applied may start new jobs.
  std::vector<std::unique_ptr<Running>> over;
  for (auto& job : running_)
    if (job->ended) over.push_back(std::move(job));
  std::erase(running_, nullptr);

  std::vector<JobView> views;
  for (const auto& job : over) {
    job->thread.join();
    JobView view = job->view(true);
    view.seconds_left.reset();
    if (job->apply) {
      try {
        job->apply();
      } catch (const std::exception& error) {
        view.state = JobState::failed;
        view.error = error.what();
      }
    }
    ended_.insert(ended_.begin(), view);
    views.push_back(std::move(view));
  }
  if (ended_.size() > ended_kept) ended_.resize(ended_kept);
  return views;
}

void Jobs::wait_for_work() const {
  for (const auto& job : running_) job->ended.wait(false);
}

std::vector<JobView> Jobs::view() const {
  std::vector<JobView> views;
  for (const auto& job : running_) views.push_back(job->view());
  views.insert(views.end(), ended_.begin(), ended_.end());
  return views;
}

}  // namespace archetype
