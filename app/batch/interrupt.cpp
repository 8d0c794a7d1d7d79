// A thread of its own takes the signals, so that nothing has to be safe inside a signal handler.
#include "app/batch/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <ctime>

#include "app/batch/command.h"

namespace archetype {

namespace {

constexpr timespec patience{0, 900'000'000};  // seconds, nanoseconds

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::thread([this] { wait_for_signals(); });
}

Interrupt::~Interrupt() {
  over_ = true;
  pthread_kill(waiter_.native_handle(), SIGINT);
  waiter_.join();
}

void Interrupt::wait_for_signals() {
  const sigset_t set = stop_signals();
  int received = 0;
  sigwait(&set, &received);
  if (over_) return;
  source_.request_stop();
  // Woken early by a second signal of the user, or by the destructor.
  sigtimedwait(&set, nullptr, &patience);
  if (!over_) _exit(exit_code::stopped);
}

}  // namespace archetype
