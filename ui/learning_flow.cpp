#include "ui/learning_flow.h"

#include <algorithm>
#include <map>

namespace archetype {
namespace {

std::size_t first_line(const LearningRecord& record, std::size_t line) {
  while (record.lines[line].parent) line = *record.lines[line].parent;
  return line;
}

// The node of the column before that the shape was at.
std::size_t node_of(const FlowColumn& column, std::size_t shape) {
  for (std::size_t n = 0; n < column.nodes.size(); ++n)
    if (std::ranges::binary_search(column.nodes[n].members, shape)) return n;
  return 0;
}

FlowColumn start_column(const LearningRecord& record) {
  FlowColumn column;
  for (std::size_t i = 0; i < record.start.size(); ++i) column.nodes.push_back({i, &record.start[i]});
  for (std::size_t shape = 0; shape < record.judging.size(); ++shape) {
    std::size_t line = 0;
    if (!record.steps.empty()) {
      const LearningStep& first = record.steps.front();
      line = first_line(record, first.lines[first.taken[shape]]);
    }
    column.nodes[line].members.push_back(shape);
  }
  return column;
}

void connect(const FlowColumn& before, FlowColumn& column) {
  std::map<std::pair<std::size_t, std::size_t>, FlowBand> bands;
  for (std::size_t to = 0; to < column.nodes.size(); ++to) {
    for (const std::size_t shape : column.nodes[to].members) {
      const std::size_t from = node_of(before, shape);
      FlowBand& band = bands[{from, to}];
      band.from = from;
      band.to = to;
      band.moved = before.nodes[from].line != column.nodes[to].line;
      band.shapes.push_back(shape);
      column.moved += band.moved;
    }
  }
  for (auto& [ends, band] : bands) column.bands.push_back(std::move(band));
}

void find_ends(const FlowColumn& before, FlowColumn& column) {
  for (std::size_t from = 0; from < before.nodes.size(); ++from) {
    if (std::ranges::find(column.nodes, before.nodes[from].line, &FlowNode::line) != column.nodes.end())
      continue;
    FlowEnd end{from, std::nullopt};
    if (std::ranges::count(column.bands, from, &FlowBand::from) == 1)
      end.into = std::ranges::find(column.bands, from, &FlowBand::from)->to;
    column.ended.push_back(end);
  }
}

}  // namespace

const PartTemplate* find_learned(const LearningRecord& record, TemplateId id) {
  const auto found = std::ranges::lower_bound(record.templates, id, {}, &TemplateRecord::id);
  return &found->part_template;
}

std::vector<FlowColumn> learning_flow(const LearningRecord& record) {
  std::vector<FlowColumn> columns{start_column(record)};
  for (const LearningStep& step : record.steps) {
    FlowColumn column;
    column.round = step.iteration;
    for (std::size_t t = 0; t < step.templates.size(); ++t) {
      FlowNode node{step.lines[t], find_learned(record, step.templates[t])};
      node.spawned = record.lines[node.line].parent && record.lines[node.line].born == step.iteration;
      const auto same = [&](const FlowNode& before) { return before.part_template == node.part_template; };
      const bool first = column.round == 1 && node.line < record.start.size();
      node.changed = first ? *node.part_template != record.start[node.line]
                           : std::ranges::none_of(columns.back().nodes, same);
      column.nodes.push_back(std::move(node));
    }
    for (std::size_t shape = 0; shape < step.taken.size(); ++shape)
      column.nodes[step.taken[shape]].members.push_back(shape);
    connect(columns.back(), column);
    find_ends(columns.back(), column);
    columns.push_back(std::move(column));
  }
  return columns;
}

std::string end_text(const FlowColumn& before, const FlowColumn& column, const FlowEnd& end) {
  const FlowNode& gone = before.nodes[end.from];
  const std::string name = "“" + gone.part_template->name + "”";
  if (!end.into)
    return name +
           " is gone: " + (gone.members.empty() ? "no shape took it" : "its shapes take several others");
  const FlowNode& into = column.nodes[*end.into];
  const std::string with = "“" + into.part_template->name + "”";
  if (into.changed) return name + " and " + with + " became one, " + with;
  return name + " is gone: its shapes take " + with;
}

std::string round_name(std::size_t round) {
  return round == 0 ? "the start" : "round " + std::to_string(round);
}

}  // namespace archetype
