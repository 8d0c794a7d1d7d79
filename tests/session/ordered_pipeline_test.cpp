#include "core/session/ordered_pipeline.h"

#include "core/session/commit_pace.h"

#include <doctest/doctest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace archetype;

TEST_CASE("results are taken in order, and a ring of the window's size holds all that is in work") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    std::vector<std::size_t> ring(pipeline_window(threads));
    std::vector<std::size_t> taken;
    std::size_t last_report = 0;
    JobControl control;
    control.report = [&](std::size_t done, std::size_t total, std::string_view what) {
      CHECK(done == last_report + 1);
      CHECK(total == 500);
      CHECK(what == "counting");
      last_report = done;
    };
    const bool all =
        ordered_pipeline(500, threads, control, "counting",
                         {.prepare = [&](std::size_t i) { ring[i % ring.size()] = i; },
                          .compute = [&](std::size_t i) { ring[i % ring.size()] += 1000; },
                          .finish = [&](std::size_t i) { taken.push_back(ring[i % ring.size()]); }});
    CHECK(all);
    CHECK(last_report == 500);
    std::vector<std::size_t> expected(500);
    std::iota(expected.begin(), expected.end(), 1000);
    CHECK(taken == expected);
  }
}

TEST_CASE("a cancelled pipeline finishes what it is computing and nothing more") {
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  std::atomic<std::size_t> computed = 0;
  std::size_t finished = 0;
  const bool all = ordered_pipeline(100'000, 2, control, "counting",
                                    {.prepare = {},
                                     .compute = [&](std::size_t) { ++computed; },
                                     .finish =
                                         [&](std::size_t i) {
                                           CHECK(i == finished);
                                           if (++finished == 10) source.request_stop();
                                         }});
  CHECK_FALSE(all);
  CHECK(computed == finished);
  CHECK(finished <= 10 + pipeline_window(2));
}

TEST_CASE("what waits to be computed when the pipeline is cancelled is left out") {
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  std::size_t prepared = 0;
  std::size_t computed = 0;
  const bool all = ordered_pipeline(100, 1, control, "counting",
                                    {.prepare =
                                         [&](std::size_t) {
                                           if (++prepared == pipeline_window(1)) source.request_stop();
                                         },
                                     .compute = [&](std::size_t) { ++computed; },
                                     .finish = [](std::size_t) {}});
  CHECK_FALSE(all);
  CHECK(computed < prepared);
}

TEST_CASE("an exception of any step ends the pipeline and is thrown on") {
  const auto nothing = [](std::size_t) {};
  const auto fail = [](std::size_t i) {
    if (i == 20) throw std::runtime_error("twenty");
  };
  CHECK_THROWS_WITH(ordered_pipeline(100, 2, {}, "", {fail, nothing, nothing}), "twenty");
  CHECK_THROWS_WITH(ordered_pipeline(100, 2, {}, "", {{}, fail, nothing}), "twenty");
  CHECK_THROWS_WITH(ordered_pipeline(100, 2, {}, "", {{}, nothing, fail}), "twenty");
  CHECK(ordered_pipeline(0, 2, {}, "", {{}, fail, fail}));
}

TEST_CASE("what is done is committed in batches, after a second, and at once when the work is stopped") {
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  CommitPace pace;
  CHECK_FALSE(pace.due(1, control));
  CHECK(pace.due(16, control));
  std::this_thread::sleep_for(std::chrono::milliseconds(1010));
  CHECK_FALSE(pace.due(0, control));
  CHECK(pace.due(1, control));
  pace.committed();
  CHECK_FALSE(pace.due(1, control));
  source.request_stop();
  CHECK(pace.due(1, control));
}
