#include "core/learning/child_name.h"

namespace archetype {

namespace {

// "chair" for "chair 2"; what is not numbered stays as it is.
std::string without_number(const std::string& name) {
  const std::size_t space = name.find_last_not_of("0123456789");
  const bool numbered =
      space != std::string::npos && space > 0 && name[space] == ' ' && space + 1 < name.size();
  return numbered ? name.substr(0, space) : name;
}

}  // namespace

std::string child_name(const std::string& parent, const std::set<std::string>& taken) {
  const std::string first = without_number(parent);
  const std::string& family = taken.contains(first) ? first : parent;
  for (int number = 2;; ++number) {
    std::string name = family + " " + std::to_string(number);
    if (!taken.contains(name)) return name;
  }
}

}  // namespace archetype
