// How long work reports its progress and hears that it shall stop, or rest for a while.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <utility>

namespace archetype {

// Work that comes to a closed gate sleeps there until it is opened, or the work shall stop. Thread-safe.
class PauseGate {
 public:
  void close() { set(true); }
  void open() { set(false); }
  bool closed() const { return closed_; }
  void wait(const std::stop_token& stop) const {
    if (!closed_) return;
    std::unique_lock lock(mutex_);
    opened_.wait(lock, stop, [this] { return !closed_; });
  }

 private:
  void set(bool closed) {
    {
      const std::lock_guard lock(mutex_);
      closed_ = closed;
    }
    opened_.notify_all();
  }

  std::atomic<bool> closed_ = false;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any opened_;
};

// A stop token at which work can also be paused: asking it waits while the gate is closed. It is handed on as
// a token would be. Converted to a plain token it does not wait, as code must that holds a lock or a
// transaction.
class StopSignal {
 public:
  StopSignal() = default;
  StopSignal(std::stop_token token, std::shared_ptr<const PauseGate> gate = {})
      : token_(std::move(token)), gate_(std::move(gate)) {}

  bool stop_requested() const {
    if (gate_) gate_->wait(token_);
    return token_.stop_requested();
  }
  bool paused() const { return gate_ && gate_->closed(); }
  operator std::stop_token() const { return token_; }

 private:
  std::stop_token token_;
  std::shared_ptr<const PauseGate> gate_;  // null: never paused
};

// Handed by reference to every function that may run for more than 50 ms. A default-made one never stops and
// reports nowhere. `report` may be called from several threads at once; what it is given is only valid during
// the call. Cancelled functions return early, with a value that says so; they leave nothing half written.
struct JobControl {
  StopSignal stop;
  // done, total: counts of one unit of work (shapes, say); total may grow while work is found.
  std::function<void(std::size_t done, std::size_t total, std::string_view what)> report;

  // Sleeps while the work is paused: not to be asked within a transaction.
  bool cancelled() const { return stop.stop_requested(); }
  void progress(std::size_t done, std::size_t total, std::string_view what) const {
    if (report) report(done, total, what);
  }
};

}  // namespace archetype
