#include "core/session/messages.h"

#include <utility>

namespace archetype {

void Messages::add(Severity severity, std::string text) {
  constexpr std::size_t kept = 1000;
  list_.push_back({severity, std::move(text)});
  if (list_.size() > kept) list_.pop_front();
  ++count_;
}

}  // namespace archetype
