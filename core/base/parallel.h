// Deterministic parallel loops.
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/job_control.h"

namespace archetype {

// Calls body(i) for every i in [0, n) on up to `threads` threads (0: as many as the machine has). Bodies
// write to their own slot and nothing else, so the result does not depend on the number of threads. Stops
// handing out work when `control` is cancelled; returns false then. The first exception of a body ends the
// loop and is thrown on. Progress is reported as (bodies done, n, what).
bool parallel_for(std::size_t n, unsigned threads, const JobControl& control, const char* what,
                  const std::function<void(std::size_t)>& body);

// How many threads TBB may have while a loop with `threads` of them runs (for tbb::global_control, which by
// itself allows as many as the machine has, and warns where more are asked for): those of the machine
// besides, since a job that is paused keeps its own asleep.
std::size_t allowed_threads(unsigned threads);

}  // namespace archetype
