// Background jobs: results come to the thread that polls, cancel is heard, errors become messages.
#include "core/session/jobs.h"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

using namespace archetype;
using namespace std::chrono_literals;

namespace {

// Polls until the jobs have ended, and gives the views of those that did.
std::vector<JobView> finish(Jobs& jobs) {
  std::vector<JobView> ended;
  for (int i = 0; i < 2000 && !jobs.idle(); ++i) {
    for (JobView& view : jobs.poll()) ended.push_back(std::move(view));
    std::this_thread::sleep_for(1ms);
  }
  return ended;
}

// Works until it is told to stop.
Jobs::Apply wait_for_stop(const JobControl& control) {
  while (!control.cancelled()) std::this_thread::sleep_for(1ms);
  return {};
}

}  // namespace

TEST_CASE("A result is applied once, on the thread that polls") {
  Jobs jobs;
  std::thread::id applied_on;
  int applied = 0;
  jobs.start("Count", [&](const JobControl&) -> Jobs::Apply {
    return [&] {
      applied_on = std::this_thread::get_id();
      ++applied;
    };
  });
  const auto ended = finish(jobs);
  REQUIRE(ended.size() == 1);
  CHECK(ended[0].state == JobState::done);
  CHECK(applied == 1);
  CHECK(applied_on == std::this_thread::get_id());
}

TEST_CASE("Several jobs run at once and one can be cancelled") {
  Jobs jobs;
  const JobId first = jobs.start("First", wait_for_stop);
  jobs.start("Second", wait_for_stop);
  CHECK(jobs.view().size() == 2);
  jobs.cancel(first);
  std::vector<JobView> ended;
  for (int i = 0; i < 2000 && ended.empty(); ++i) {
    ended = jobs.poll();
    std::this_thread::sleep_for(1ms);
  }
  REQUIRE(ended.size() == 1);
  CHECK(ended[0].title == "First");
  CHECK(ended[0].state == JobState::cancelled);
  CHECK_FALSE(jobs.idle());
  CHECK(jobs.view()[0].title == "Second");
  jobs.cancel_all();
  CHECK(finish(jobs).size() == 1);
}

TEST_CASE("What a job or its result throws becomes its error") {
  Jobs jobs;
  jobs.start("Work", [](const JobControl&) -> Jobs::Apply { throw std::runtime_error("disk full"); });
  jobs.start("Apply",
             [](const JobControl&) -> Jobs::Apply { return [] { throw std::runtime_error("moved on"); }; });
  auto ended = finish(jobs);
  REQUIRE(ended.size() == 2);
  for (const JobView& view : ended) {
    CHECK(view.state == JobState::failed);
    CHECK(view.error == (view.title == "Work" ? "disk full" : "moved on"));
  }
}

TEST_CASE("Progress is seen while the job runs") {
  std::atomic<int> woken = 0;
  Jobs waking([&] { ++woken; });
  waking.start("Steps", [](const JobControl& control) -> Jobs::Apply {
    control.progress(3, 10, "shapes");
    control.progress(2, 10, "shapes");  // a slower thread: the bar does not go back
    return wait_for_stop(control);
  });
  for (int i = 0; i < 2000 && waking.view()[0].done != 3; ++i) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(5ms);
  const JobView view = waking.view()[0];
  CHECK(view.done == 3);
  CHECK(view.total == 10);
  CHECK(view.doing == "shapes");
  CHECK(woken > 0);
  waking.cancel_all();
  CHECK(waking.view()[0].active());
  finish(waking);
  CHECK_FALSE(waking.view()[0].active());
}

TEST_CASE("The time left is that of the rest at the same pace") {
  CHECK(estimate_seconds_left(10, 25, 100) == doctest::Approx(30));
  CHECK(estimate_seconds_left(10, 100, 100) == doctest::Approx(0));
  CHECK_FALSE(estimate_seconds_left(0.5, 25, 100));
  CHECK_FALSE(estimate_seconds_left(10, 0, 100));
  CHECK_FALSE(estimate_seconds_left(10, 5, 0));
}

TEST_CASE("Jobs that still run are stopped when the list goes") {
  std::atomic<bool> stopped = false;
  {
    Jobs jobs;
    jobs.start("Endless", [&](const JobControl& control) {
      Jobs::Apply none = wait_for_stop(control);
      stopped = true;
      return none;
    });
  }
  CHECK(stopped);
}
