// What templates that are born in learning are called.
#pragma once

#include <set>
#include <string>

namespace archetype {

// The parent's name with the first number that is free among `taken`, from 2 on. A parent that is a numbered
// child of a template that is still there passes that one's name on: "chair 2" has the child "chair 3", not
// "chair 2 2".
std::string child_name(const std::string& parent, const std::set<std::string>& taken);

}  // namespace archetype
