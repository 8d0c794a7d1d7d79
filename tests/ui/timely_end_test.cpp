// The process ends in time, whatever it is held up by.
#include "app/studio/timely_end.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace archetype;

TEST_CASE("A process that does not come to its end by itself is ended with its status") {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    end_within(std::chrono::milliseconds(50), 3);
    for (;;) pause();
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 3);
}
