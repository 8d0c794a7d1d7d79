// Background jobs: results come to the thread that polls, cancel is heard, errors become messages.
#include "core/session/jobs.h"

#include <doctest/doctest.h>

#include <atomic>
#include <ctime>
#include <stdexcept>
#include <thread>

#include "core/base/parallel.h"

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

// Counts, on two threads, until it is told to stop.
struct Counting {
  std::atomic<int> count = 0;
  Jobs::Work work() {
    return [this](const JobControl& control) -> Jobs::Apply {
      parallel_for(1'000'000, 2, control, "counting", [this](std::size_t) {
        ++count;
        std::this_thread::sleep_for(1ms);
      });
      return {};
    };
  }
  void wait_for(int wanted) const {
    for (int i = 0; i < 10'000 && count < wanted; ++i) std::this_thread::sleep_for(1ms);
    REQUIRE(count >= wanted);
  }
  // What is under way when a job is paused comes to its end first.
  void wait_until_still() const {
    for (int before = -1; before != count; std::this_thread::sleep_for(50ms)) before = count;
  }
};

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

TEST_CASE("What has ended is under way until its result is applied") {
  Jobs jobs;
  bool applied = false;
  jobs.start("Save", [&](const JobControl&) -> Jobs::Apply { return [&] { applied = true; }; });
  jobs.wait_for_work();
  CHECK(jobs.view()[0].active());
  CHECK_FALSE(jobs.resting());
  CHECK_FALSE(applied);
  jobs.poll();
  CHECK(applied);
  CHECK(jobs.view()[0].state == JobState::done);
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

TEST_CASE("A paused job does nothing, takes no processor time and goes on where it was") {
  Jobs jobs;
  Counting counting;
  const JobId job = jobs.start("Count", counting.work());
  counting.wait_for(20);
  CHECK_FALSE(jobs.resting());
  jobs.pause(job);
  CHECK(jobs.view()[0].state == JobState::paused);
  CHECK(jobs.view()[0].active());
  CHECK(jobs.resting());
  CHECK_FALSE(jobs.idle());
  counting.wait_until_still();
  const int before = counting.count;
  const std::clock_t processor = std::clock();
  std::this_thread::sleep_for(300ms);
  CHECK(counting.count == before);
  CHECK(static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC < 0.05);
  jobs.resume(job);
  CHECK(jobs.view()[0].state == JobState::running);
  counting.wait_for(before + 20);
  jobs.cancel_all();
  CHECK(finish(jobs).at(0).state == JobState::cancelled);
}

TEST_CASE("A paused job that is stopped ends at once, without going on") {
  Jobs jobs;
  Counting counting;
  jobs.start("Count", counting.work());
  counting.wait_for(20);
  jobs.pause_all();
  counting.wait_until_still();
  const int before = counting.count;
  const auto start = std::chrono::steady_clock::now();
  jobs.cancel_all();
  CHECK(jobs.view()[0].state == JobState::stopping);
  CHECK(finish(jobs).at(0).state == JobState::cancelled);
  CHECK(std::chrono::steady_clock::now() - start < 1s);
  CHECK(counting.count <= before + 2);
  Jobs also_when_the_list_goes;
  also_when_the_list_goes.start("Wait", wait_for_stop);
  also_when_the_list_goes.pause_all();
}

TEST_CASE("Neither the time of a job nor its estimate counts a pause, and the estimate is that of the step") {
  Jobs jobs;
  std::atomic<int> step = 0;
  const JobId job = jobs.start("Steps", [&](const JobControl& control) -> Jobs::Apply {
    control.progress(1, 2, "first");
    while (step == 0 && !control.cancelled()) std::this_thread::sleep_for(1ms);
    control.progress(1, 2, "second");
    step = 2;
    return wait_for_stop(control);
  });
  std::this_thread::sleep_for(1100ms);
  jobs.pause(job);
  const JobView before = jobs.view()[0];
  std::this_thread::sleep_for(500ms);
  const JobView after = jobs.view()[0];
  CHECK(after.seconds == before.seconds);
  REQUIRE(before.seconds_left);
  CHECK(after.seconds_left == before.seconds_left);
  jobs.resume(job);
  CHECK(jobs.view()[0].seconds < before.seconds + 0.4);
  step = 1;
  while (step != 2) std::this_thread::sleep_for(1ms);
  CHECK_FALSE(jobs.view()[0].seconds_left);  // the second step is not a second old
  jobs.cancel_all();
  finish(jobs);
}

TEST_CASE("The estimate goes on where the total changes on the way") {
  Jobs jobs;
  std::atomic<bool> changed = false;
  jobs.start("Finding", [&](const JobControl& control) -> Jobs::Apply {
    control.progress(4, 100, "fitting");
    std::this_thread::sleep_for(1100ms);
    control.progress(5, 20, "fitting");
    changed = true;
    return wait_for_stop(control);
  });
  while (!changed) std::this_thread::sleep_for(1ms);
  const JobView view = jobs.view()[0];
  CHECK(view.total == 20);
  REQUIRE(view.seconds_left);
  CHECK(*view.seconds_left == doctest::Approx(3 * view.seconds).epsilon(0.1));
  jobs.cancel_all();
  finish(jobs);
}

TEST_CASE("A loop of many bodies with one name shows each of its runs from the beginning") {
  Jobs jobs;
  std::atomic<bool> again = false;
  jobs.start("Loops", [&](const JobControl& control) -> Jobs::Apply {
    control.progress(10, 10, "fitting");
    control.progress(1, 10, "fitting");
    again = true;
    return wait_for_stop(control);
  });
  while (!again) std::this_thread::sleep_for(1ms);
  CHECK(jobs.view()[0].done == 1);
  jobs.cancel_all();
  finish(jobs);
}

TEST_CASE("A paused job leaves other jobs their threads") {
  Jobs jobs;
  Counting counting;
  jobs.start("Count", counting.work());
  counting.wait_for(20);
  jobs.pause_all();
  counting.wait_until_still();
  // Two bodies that wait for each other: with one thread they would wait in vain.
  std::atomic<int> there = 0;
  std::atomic<bool> met = false;
  parallel_for(2, 2, {}, "meeting", [&](std::size_t) {
    ++there;
    for (int i = 0; i < 5000 && there < 2; ++i) std::this_thread::sleep_for(1ms);
    if (there == 2) met = true;
  });
  CHECK(met);
}

TEST_CASE("what the work of a job holds is let go of before the job has ended") {
  struct Slow {
    std::atomic<bool>* gone;
    ~Slow() {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      *gone = true;
    }
  };
  std::atomic<bool> gone = false;
  Jobs jobs;
  jobs.start("hold", [held = std::make_shared<Slow>(&gone)](const JobControl&) -> Jobs::Apply { return {}; });
  jobs.wait_for_work();
  CHECK(gone);
}
