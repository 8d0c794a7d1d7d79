#include "tests/ui/made_learning.h"

#include <algorithm>

#include "tests/support/small_collection.h"

namespace archetype::test {

LearningRecord made_learning(std::size_t rounds, std::size_t templates, std::size_t shapes) {
  LearningRecord record;
  record.start.push_back(chair_template());
  record.lines.emplace_back();
  for (std::size_t i = 0; i < shapes; ++i) record.judging.push_back(static_cast<ShapeId>(i + 1));
  std::vector<TemplateId> ids{0};
  const auto add_template = [&](const std::string& name, double width) {
    TemplateRecord made;
    made.id = static_cast<TemplateId>(record.templates.size() + 1);
    made.part_template = record.start[0];
    made.part_template.name = name;
    made.part_template.parts[0].scale.mean.x() = width;
    record.templates.push_back(made);
    return made.id;
  };
  for (std::size_t round = 1; round <= rounds; ++round) {
    const auto r = static_cast<double>(round);
    ids[0] = add_template(record.start[0].name, 0.5 + 0.1 / r);
    if (ids.size() < templates) {
      record.lines.push_back({ids.size() - 1, static_cast<int>(round)});
      ids.push_back(add_template("chair " + std::to_string(ids.size() + 1), 0.6 + 0.1 * r));
    }
    LearningStep step{static_cast<int>(round), 0.1 + 1 / r, 0.1 + 1 / (r + 1), ids, {}, {}};
    for (std::size_t t = 0; t < ids.size(); ++t) step.lines.push_back(t);
    for (std::size_t i = 0; i < shapes; ++i)
      step.taken.push_back(i < round ? ids.size() - 1 : i % ids.size());
    record.steps.push_back(step);
  }
  return record;
}

}  // namespace archetype::test
