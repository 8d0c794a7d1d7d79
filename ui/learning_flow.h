// How the shapes move between templates while these are learned: rounds as columns, templates as bands.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/learn_templates.h"

namespace archetype {

// A template in a round.
struct FlowNode {
  std::size_t line = 0;  // of LearningRecord
  const PartTemplate* part_template = nullptr;
  bool spawned = false;                   // in this round
  bool changed = false;                   // re-estimated or spawned in this round
  std::vector<std::size_t> members = {};  // indices into LearningRecord::judging
};

// The judging shapes that took one template before and take another one, or the same, now.
struct FlowBand {
  std::size_t from = 0;             // a node of the column before
  std::size_t to = 0;               // a node of this one
  bool moved = false;               // to another line
  std::vector<std::size_t> shapes;  // indices into LearningRecord::judging
};

// A line that goes on no more.
struct FlowEnd {
  std::size_t from = 0;  // its node in the column before
  std::optional<std::size_t>
      into;  // the node that has all of its shapes now; nothing: it had none, or several do
};

struct FlowColumn {
  int round = 0;  // 0: what learning began with
  std::vector<FlowNode> nodes;
  std::vector<FlowBand> bands;  // from the column before; ordered by from, then to
  std::vector<FlowEnd> ended;
  std::size_t moved = 0;  // shapes
};

// One of the templates of its rounds. Points into the record.
const PartTemplate* find_learned(const LearningRecord& record, TemplateId id);

// One column more than there are whole rounds. Which shapes took which template at the start is not stored:
// they count to that which theirs after the first round comes from. Points into the record.
std::vector<FlowColumn> learning_flow(const LearningRecord& record);

// What became of it: "“stool” and “chair” became one, “chair”".
std::string end_text(const FlowColumn& before, const FlowColumn& column, const FlowEnd& end);

std::string round_name(std::size_t round);  // "the start", "round 1"

}  // namespace archetype
