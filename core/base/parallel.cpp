#include "core/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace archetype {

std::size_t allowed_threads(unsigned threads) {
  const auto of_machine = static_cast<std::size_t>(tbb::info::default_concurrency());
  return std::max<std::size_t>(threads, of_machine) + of_machine;
}

bool parallel_for(std::size_t n, unsigned threads, const JobControl& control, const char* what,
                  const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> done = 0;
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, allowed_threads(threads));
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] {
    tbb::task_group_context context;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) {
            if (control.cancelled()) {
              context.cancel_group_execution();
              return;
            }
            body(i);
            control.progress(++done, n, what);
          }
        },
        tbb::simple_partitioner{}, context);
  });
  return done == n;
}

}  // namespace archetype
