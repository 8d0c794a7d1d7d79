// Parallel work on a long list with results taken in order and little held at a time.
#pragma once

#include <functional>

#include "core/base/job_control.h"

namespace archetype {

// What is done with item i of a list.
struct PipelineSteps {
  std::function<void(std::size_t)> prepare;  // may be empty
  std::function<void(std::size_t)> compute;
  std::function<void(std::size_t)> finish;
};

// Items that are between prepare and finish at any time: i and i + pipeline_window(threads) are never both,
// so that a ring of that many slots holds all that is in work.
std::size_t pipeline_window(unsigned threads);

// Calls prepare(i), compute(i) and finish(i) for every i in [0, n). prepare and finish run in the order of i
// and never at the same time as each other, so both may use a project; compute runs on up to `threads`
// threads (0: all). Cancelled, it computes no further item, finishes those that are being computed (one
// before them may be left out) and returns false.
// The first exception ends the work and is thrown on. Progress is reported as (items finished, n, what).
bool ordered_pipeline(std::size_t n, unsigned threads, const JobControl& control, const char* what,
                      const PipelineSteps& steps);

}  // namespace archetype
