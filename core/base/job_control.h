// How long work reports its progress and hears that it shall stop.
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace archetype {

// Handed by reference to every function that may run for more than 50 ms. A default-made one never stops and
// reports nowhere. `report` may be called from several threads at once; what it is given is only valid during
// the call. Cancelled functions return early, with a value that says so; they leave nothing half written.
struct JobControl {
  std::stop_token stop;
  // done, total: counts of one unit of work (shapes, say); total may grow while work is found.
  std::function<void(std::size_t done, std::size_t total, std::string_view what)> report;

  bool cancelled() const { return stop.stop_requested(); }
  void progress(std::size_t done, std::size_t total, std::string_view what) const {
    if (report) report(done, total, what);
  }
};

}  // namespace archetype
