#include "core/session/yaw_votes.h"

#include <algorithm>

#include "core/fitting/agreed_yaws.h"
#include "core/session/current_templates.h"
#include "core/session/fit_state.h"
#include "core/session/yaw_energies.h"

namespace archetype {
namespace {

void add_spread(std::vector<ShapeId>& asked, const std::vector<ShapeId>& ids, std::size_t count) {
  count = std::min(count, ids.size());
  for (std::size_t i = 0; i < count; ++i) asked.push_back(ids[i * ids.size() / count]);
}

}  // namespace

std::vector<ShapeId> yaw_voters(const Project& project, const KnownYaws& known) {
  std::vector<ShapeId> turned;
  std::vector<ShapeId> others;
  for (const ShapeId id : project.shape_ids()) (known.contains(id) ? turned : others).push_back(id);
  std::vector<ShapeId> asked;
  add_spread(asked, turned, AgreedYaws::most_references);
  add_spread(asked, others, AgreedYaws::most_references - asked.size());
  return asked;
}

std::optional<std::array<double, 4>> kept_yaw_costs(const Project& project, ShapeId shape,
                                                    const JobControl& control) {
  const auto [templates, ids] = current_templates(project);
  const KnownYaws known = learned_yaws(project, ids);
  const std::vector<ShapeId> asked = yaw_voters(project, known);
  const ContentHash state = yaw_energies_state(project, fit_state(templates, {}), asked);
  std::optional<YawEnergies> energies = kept_yaw_energies(project, state, asked.size());
  if (!energies) return std::nullopt;
  const auto known_of = [&](ShapeId id) {
    const auto found = known.find(id);
    return found == known.end() ? std::nullopt : std::optional(found->second);
  };
  std::vector<ShapeSamples> references;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (control.cancelled()) return std::nullopt;
    references.push_back(project.samples(asked[i]));
    add_cost_of_turning((*energies)[i], known_of(asked[i]));
  }
  const AgreedYaws agreed(references, *energies, control);
  if (control.cancelled()) return std::nullopt;
  std::array<double, 4> costs = agreed.costs(project.samples(shape));
  add_cost_of_turning(costs, known_of(shape));
  return costs;
}

}  // namespace archetype
