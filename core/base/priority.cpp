#include "core/base/priority.h"

#include <sys/resource.h>

namespace archetype {

void lower_priority(Priority to) {
  // On Linux 0 stands for the thread, not for the process. The kernel knows no less than 19; that a thread
  // could not be lowered does no harm.
  const int steps = to == Priority::answer ? 5 : 10;
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps);
}

}  // namespace archetype
