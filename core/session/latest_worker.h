// A background worker that always computes the newest request: what is older and still waits is forgotten.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "core/base/job_control.h"
#include "core/base/priority.h"

namespace archetype {

// What runs is finished rather than cancelled when a newer request comes: under a stream of edits faster than
// the work (a drag) something must come out. A request that makes the running one worthless says so.
//
// request() and poll() are for one thread. A cancelled `work` returns nothing; what it throws is kept for
// take_problem().
template <typename Request, typename Result>
class LatestWorker {
 public:
  using Work = std::function<std::optional<Result>(const Request&, const JobControl&)>;

  // `wake` is called from the worker's thread whenever poll() has a result.
  LatestWorker(Work work, std::function<void()> wake)
      : work_(std::move(work)), wake_(std::move(wake)), thread_([this](std::stop_token stop) {
          lower_priority(Priority::answer);
          run(stop);
        }) {}
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;
  ~LatestWorker() {
    thread_.request_stop();
    cancel();
  }

  void request(Request request, bool running_is_stale) {
    {
      const std::lock_guard lock(mutex_);
      waiting_ = std::move(request);
      if (running_is_stale) {
        running_stop_.request_stop();
        result_.reset();
      }
    }
    changed_.notify_all();
  }
  // Forgets what waits, runs or was not taken yet.
  void cancel() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    result_.reset();
    running_stop_.request_stop();
  }
  // Returns when poll() has a result, nothing is under way, or `most` has passed.
  void wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, most, [this] { return result_ || (!waiting_ && !running_); });
  }
  std::optional<Result> poll() {
    const std::lock_guard lock(mutex_);
    return std::exchange(result_, std::nullopt);
  }
  // Why the last request that failed did so, once; "" if none has.
  std::string take_problem() {
    const std::lock_guard lock(mutex_);
    return std::exchange(problem_, {});
  }
  bool idle() const {
    const std::lock_guard lock(mutex_);
    return !waiting_ && !running_ && !result_;
  }

 private:
  void run(const std::stop_token& stop) {
    for (;;) {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
      const Request request = std::move(*waiting_);
      waiting_.reset();
      running_ = true;
      running_stop_ = std::stop_source();
      JobControl control;
      control.stop = running_stop_.get_token();
      lock.unlock();
      std::optional<Result> result;
      std::string problem;
      try {
        result = work_(request, control);
      } catch (const std::bad_alloc&) {
        problem = "there is not enough memory";
      } catch (const std::exception& error) {
        problem = error.what();
      }
      lock.lock();
      running_ = false;
      if (!problem.empty()) problem_ = std::move(problem);
      if (control.cancelled() || stop.stop_requested()) result.reset();
      if (result) result_ = std::move(result);
      lock.unlock();
      changed_.notify_all();
      if (wake_) wake_();
    }
  }

  Work work_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards the five below
  std::optional<Request> waiting_;
  std::optional<Result> result_;
  bool running_ = false;
  std::stop_source running_stop_;
  std::string problem_;
  std::condition_variable_any changed_;
  std::jthread thread_;  // last: it is joined before the rest goes
};

}  // namespace archetype
