// The worker that always computes the newest request.
#include "core/session/latest_worker.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>

using namespace archetype;
using namespace std::chrono_literals;

namespace {

using Worker = LatestWorker<int, int>;

std::optional<int> wait_for(Worker& worker) {
  for (int i = 0; i < 5000; ++i) {
    if (auto result = worker.poll()) return result;
    std::this_thread::sleep_for(1ms);
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("What waits is replaced by what is newer; what runs is finished") {
  std::atomic<bool> hold = true;
  std::atomic<int> started = 0;
  Worker worker(
      [&](const int& request, const JobControl&) -> std::optional<int> {
        ++started;
        while (hold) std::this_thread::sleep_for(1ms);
        return request;
      },
      {});
  worker.request(1, false);
  while (started == 0) std::this_thread::sleep_for(1ms);
  worker.request(2, false);
  worker.request(3, false);
  CHECK_FALSE(worker.idle());
  hold = false;
  CHECK(wait_for(worker).has_value());
  for (int i = 0; i < 5000 && !worker.idle(); ++i) {
    worker.poll();
    std::this_thread::sleep_for(1ms);
  }
  CHECK(started == 2);  // 1 and 3
}

TEST_CASE("A request that makes the running one stale cancels it") {
  Worker worker(
      [](const int& request, const JobControl& control) -> std::optional<int> {
        while (request == 1 && !control.cancelled()) std::this_thread::sleep_for(1ms);
        return request;
      },
      {});
  worker.request(1, false);
  std::this_thread::sleep_for(10ms);
  worker.request(2, true);
  CHECK(wait_for(worker) == 2);
}

TEST_CASE("One can wait for a result a little, and for nothing when nothing is under way") {
  const auto elapsed = [start = std::chrono::steady_clock::now()] {
    return std::chrono::steady_clock::now() - start;
  };
  std::atomic<bool> hold = true;
  Worker worker(
      [&](const int& request, const JobControl&) -> std::optional<int> {
        while (hold) std::this_thread::sleep_for(1ms);
        return request;
      },
      {});
  worker.wait(1min);
  CHECK(elapsed() < 30s);
  worker.request(1, false);
  worker.wait(20ms);
  CHECK(elapsed() >= 20ms);
  CHECK_FALSE(worker.poll());
  hold = false;
  worker.wait(1min);
  CHECK(elapsed() < 30s);
  CHECK(worker.poll() == 1);
}

TEST_CASE("What a request throws is said once, and the next one is worked on") {
  Worker worker(
      [](const int& request, const JobControl&) -> std::optional<int> {
        if (request == 1) throw std::bad_alloc();
        if (request == 2) throw std::runtime_error("two");
        return request;
      },
      {});
  worker.request(1, false);
  worker.wait(1min);
  CHECK(worker.take_problem() == "there is not enough memory");
  CHECK(worker.take_problem().empty());
  worker.request(2, false);
  worker.wait(1min);
  CHECK(worker.take_problem() == "two");
  CHECK_FALSE(worker.poll());
  worker.request(3, false);
  CHECK(wait_for(worker) == 3);
}

TEST_CASE("A worker that is busy ends with its owner, within the time of a check") {
  const auto start = std::chrono::steady_clock::now();
  {
    Worker worker(
        [](const int&, const JobControl& control) -> std::optional<int> {
          while (!control.cancelled()) std::this_thread::sleep_for(1ms);
          return std::nullopt;
        },
        {});
    worker.request(1, false);
    std::this_thread::sleep_for(10ms);
  }
  CHECK(std::chrono::steady_clock::now() - start < 5s);
}
