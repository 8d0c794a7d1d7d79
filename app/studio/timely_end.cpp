#include "app/studio/timely_end.h"

#include <cstdlib>
#include <thread>

namespace archetype {

void end_within(std::chrono::milliseconds grace, int status) {
  std::thread([=] {
    std::this_thread::sleep_for(grace);
    std::_Exit(status);
  }).detach();
}

}  // namespace archetype
