#include "core/base/parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace archetype;

TEST_CASE("every index runs once, on any number of threads") {
  for (const unsigned threads : {0U, 1U, 2U, 8U}) {
    std::vector<int> hits(1000);
    CHECK(parallel_for(hits.size(), threads, {}, "counting", [&](std::size_t i) { ++hits[i]; }));
    for (const int h : hits) REQUIRE(h == 1);
  }
}

TEST_CASE("a cancelled loop stops and says so") {
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  std::atomic<int> ran = 0;
  CHECK_FALSE(parallel_for(100000, 2, control, "counting", [&](std::size_t) {
    if (++ran == 10) source.request_stop();
  }));
  CHECK(ran < 20);
}

TEST_CASE("an exception of a body is thrown on") {
  CHECK_THROWS_AS(parallel_for(100, 2, {}, "throwing",
                               [](std::size_t i) {
                                 if (i == 50) throw std::runtime_error("x");
                               }),
                  std::runtime_error);
}
