// Two templates of one collection, each learned from some of its shapes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/learning/merge_templates.h"

namespace archetype::test {

struct TwoTemplates {
  // Adds shapes of a style of chairs (add_chairs()), which take the template of that side.
  void add(const std::string& style, std::size_t count, std::size_t side);
  // Plain chairs, the first half on side 0.
  void add_halves(std::size_t count);
  // Both from the template of chairs, in two steps; `members` has what they say then.
  void learn();
  // With all of its shapes.
  std::optional<TemplateMerge> merge() const;

  std::vector<ShapeSamples> shapes;
  Sides sides;
  LearnedTemplate first;
  LearnedTemplate second;
  TemplateMembers members;
};

// For work that is to be cancelled before it begins.
JobControl cancelled();

}  // namespace archetype::test
