// What the program has to say to a person: shown in the window's list, never in a dialog that stops the work.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

namespace archetype {

enum class Severity { note, warning, error };

struct Message {
  Severity severity = Severity::note;
  std::string text;  // one line; what, where and what to do
};

// The newest thousand.
class Messages {
 public:
  void add(Severity severity, std::string text);
  void note(std::string text) { add(Severity::note, std::move(text)); }
  void warn(std::string text) { add(Severity::warning, std::move(text)); }
  void error(std::string text) { add(Severity::error, std::move(text)); }
  void clear() { list_.clear(); }

  const std::deque<Message>& list() const { return list_; }  // oldest first
  std::uint64_t count() const { return count_; }             // of all that were ever added

 private:
  std::deque<Message> list_;
  std::uint64_t count_ = 0;
};

}  // namespace archetype
