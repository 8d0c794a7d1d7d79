#include "ui/shape_in_view.h"

#include "core/fitting/energy.h"

namespace archetype {

std::vector<std::string> missing_parts(const ViewFit& view) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < view.part_template->parts.size(); ++i) {
    const TemplatePart& part = view.part_template->parts[i];
    if (part.must_exist && !view.fit.parts[i].present) names.push_back(part.name);
  }
  return names;
}

FitEnergy energy_without_missing(const ViewFit& view) {
  FitEnergy energy = view.fit.energy;
  energy.existence -= missing_must_exist_energy * static_cast<double>(missing_parts(view).size());
  return energy;
}

}  // namespace archetype
