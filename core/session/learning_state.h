// How far learning has come, as the project keeps it: a stopped run goes on from there.
#pragma once

#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "core/io/project.h"
#include "core/learning/split_template.h"
#include "core/session/learn_templates.h"

namespace archetype {

struct LearningState {
  std::string request;   // what is learned from what, as a hash
  bool settled = false;  // the last round kept nothing new
  std::vector<LearningLine> lines;
  std::vector<LearningStep> steps;
  std::vector<ShapeId> judging;
  std::vector<PartTemplate> start;  // what learning began with
  std::vector<TemplateId> ids;
  std::vector<LearnedTemplate> templates;
  std::vector<int> yaws;  // by judging shape; empty before the first round

  // The line of each current template.
  std::vector<std::size_t> current_lines() const {
    if (!steps.empty()) return steps.back().lines;
    std::vector<std::size_t> first(start.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    return first;
  }
};

// In two settings: learn_state_setting, and that of learned_yaws.h.
void store_learning_state(Project& project, const LearningState& state);
// Nothing if there is none, or what the file holds is not one: then learning starts over.
std::optional<LearningState> stored_learning_state(const Project& project);

}  // namespace archetype
