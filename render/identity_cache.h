// What was made from shared objects (uploads), kept for as long as these live and are in use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

namespace archetype {

// `Value` has byte_count(). An object is told by its address; a weak reference notices when it has died and
// the address belongs to another one.
template <class Value>
class IdentityCache {
 public:
  // Values that were not asked for in the last `idle_rounds` rounds go, and the least recently used ones go
  // until the others fit `byte_budget`; those of the current round always stay.
  IdentityCache(std::size_t byte_budget, std::uint64_t idle_rounds)
      : byte_budget_(byte_budget), idle_rounds_(idle_rounds) {}

  // The value for a pair of objects (the second may be null), made by make() if it is not there.
  template <class Make>
  Value& get(const std::shared_ptr<const void>& first, const std::shared_ptr<const void>& second, Make make) {
    const Key key{first.get(), second.get()};
    auto found = entries_.find(key);
    if (found != entries_.end() && found->second.dead()) found = erase(found);
    if (found == entries_.end() || found->first != key) {
      found = entries_.insert_or_assign(key, Entry{make(), first, second, second != nullptr, round_}).first;
      byte_count_ += found->second.value.byte_count();
    }
    found->second.last_used = round_;
    return found->second.value;
  }

  void end_round() {
    for (auto entry = entries_.begin(); entry != entries_.end();)
      entry =
          entry->second.dead() || entry->second.last_used + idle_rounds_ < round_ ? erase(entry) : ++entry;
    while (byte_count_ > byte_budget_) {
      const auto oldest = std::min_element(
          entries_.begin(), entries_.end(),
          [](const auto& a, const auto& b) { return a.second.last_used < b.second.last_used; });
      if (oldest == entries_.end() || oldest->second.last_used == round_) break;
      erase(oldest);
    }
    ++round_;
  }

  std::size_t size() const { return entries_.size(); }
  std::size_t byte_count() const { return byte_count_; }

 private:
  using Key = std::pair<const void*, const void*>;
  struct Entry {
    Value value;
    std::weak_ptr<const void> first;
    std::weak_ptr<const void> second;
    bool has_second = false;
    std::uint64_t last_used = 0;
    bool dead() const { return first.expired() || (has_second && second.expired()); }
  };
  using Entries = std::map<Key, Entry>;

  typename Entries::iterator erase(typename Entries::iterator entry) {
    byte_count_ -= entry->second.value.byte_count();
    return entries_.erase(entry);
  }

  Entries entries_;
  std::size_t byte_budget_;
  std::size_t byte_count_ = 0;
  std::uint64_t idle_rounds_;
  std::uint64_t round_ = 0;
};

}  // namespace archetype
