// Ctrl-C.
#pragma once

#include <pthread.h>

#include <atomic>
#include <stop_token>
#include <thread>

namespace archetype {

// While it lives, SIGINT and SIGTERM ask the work to stop instead of ending the program. Work that has not
// stopped within a second is cut off with exit status 130, as a second signal does: what is committed to a
// project is safe at any moment. Make it before any other thread, so that they all leave the signals to it.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  std::stop_token token() const { return source_.get_token(); }

 private:
  void wait_for_signals();

  std::stop_source source_;
  std::atomic<bool> over_ = false;
  std::thread waiter_;
};

}  // namespace archetype
