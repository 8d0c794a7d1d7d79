#include "core/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace archetype {

bool parallel_for(std::size_t n, unsigned threads, const JobControl& control, const char* what,
                  const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> done = 0;
  // TBB warns on standard error if an arena asks for more threads than it allows by itself.
  const tbb::global_control allowed(
      tbb::global_control::max_allowed_parallelism,
      std::max<std::size_t>(threads, static_cast<std::size_t>(tbb::info::default_concurrency())));
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
