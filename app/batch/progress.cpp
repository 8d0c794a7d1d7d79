// Writes progress at a bearable rate, with the time left.
#include "app/batch/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "core/session/jobs.h"

namespace archetype {

namespace {

using namespace std::chrono_literals;

std::string time_text(double seconds) {
  const long s = std::lround(std::ceil(seconds));
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + std::to_string(s / 60 % 60) + " min";
}

}  // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

JobControl Progress::control(std::stop_token stop) {
  JobControl control;
  control.stop = std::move(stop);
  control.report = [this](std::size_t done, std::size_t total, std::string_view what) {
    report(done, total, what);
  };
  return control;
}

void Progress::report(std::size_t done, std::size_t total, std::string_view what) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (what != what_) {
    what_ = what;
    begun_ = now;
    next_ = now + (terminal_ ? 0s : 2s);  // a log needs no line about what takes no time
    written_ = ended_ = false;
  }
  // Where there was more to do than was thought, all is done again and again.
  const bool ends = written_ && !ended_ && done == total;
  if (now < next_ && !ends) return;
  ended_ |= done == total;
  next_ = now + (terminal_ ? Clock::duration(100ms) : Clock::duration(5s));
  written_ = true;
  std::string line = what_ + " " + std::to_string(done) + " of " + std::to_string(total);
  const double seconds = std::chrono::duration<double>(now - begun_).count();
  if (const auto left = estimate_seconds_left(seconds, done, total); left && done != total) {
    line += ", " + time_text(*left) + " left";
  }
  std::fprintf(stderr, terminal_ ? "\r%s\033[K" : "%s\n", line.c_str());
}

}  // namespace archetype
