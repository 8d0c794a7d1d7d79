// TBB's pipeline with a lock around its two serial ends.
#include "core/session/ordered_pipeline.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <mutex>

#include "core/base/parallel.h"

namespace archetype {

namespace {

unsigned thread_count(unsigned threads) {
  return threads != 0 ? threads : static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
}

}  // namespace

std::size_t pipeline_window(unsigned threads) {
  return 2 * std::size_t{thread_count(threads)};
}

bool ordered_pipeline(std::size_t n, unsigned threads, const JobControl& control, const char* what,
                      const PipelineSteps& steps) {
  std::mutex serial;
  std::size_t begun = 0;
  std::size_t finished = 0;
  const auto begin = [&](tbb::flow_control& flow) -> std::size_t {
    if (begun == n || control.cancelled()) {
      flow.stop();
      return 0;
    }
    if (steps.prepare) {
      const std::lock_guard lock(serial);
      steps.prepare(begun);
    }
    return begun++;
  };
  struct Item {
    std::size_t index;
    bool computed;
  };
  const auto compute = [&](std::size_t i) {
    const bool wanted = !control.cancelled();
    if (wanted) steps.compute(i);
    return Item{i, wanted};
  };
  const auto finish = [&](const Item& item) {
    if (!item.computed) return;
    const std::lock_guard lock(serial);
    steps.finish(item.index);
    control.progress(++finished, n, what);
  };
  const std::size_t window = pipeline_window(threads);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    allowed_threads(thread_count(threads)));
  tbb::task_arena arena(static_cast<int>(thread_count(threads)));
  arena.execute([&] {
    using tbb::filter_mode;
    tbb::parallel_pipeline(window, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, begin) &
                                       tbb::make_filter<std::size_t, Item>(filter_mode::parallel, compute) &
                                       tbb::make_filter<Item, void>(filter_mode::serial_in_order, finish));
  });
  return finished == n;
}

}  // namespace archetype
