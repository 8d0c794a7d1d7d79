#include "core/session/cluster_terms.h"

#include <algorithm>

namespace archetype {

std::optional<ClusterTerms> cluster_terms(const Project& project, TemplateId part_template, std::size_t most,
                                          const FitOptions& options, const JobControl& control) {
  const std::optional<TemplateRecord> of = project.find_template(part_template);
  ClusterTerms terms;
  if (!of) return terms;
  terms.parts.resize(of->part_template.parts.size());
  std::vector<ShapeId> members;
  for (const FitSummary& fit : project.fits()) {
    if (fit.part_template == part_template) members.push_back(fit.shape);
  }
  const std::size_t count = std::min(members.size(), most);
  for (std::size_t i = 0; i < count; ++i) {
    if (control.cancelled()) return std::nullopt;
    const ShapeId shape = members[i * members.size() / count];
    const std::optional<FitRecord> fit = project.fit(shape);
    if (!fit || fit->part_template != part_template) continue;  // another program writes
    const ShapeSamples samples = project.samples(shape);
    const FitInspection inspection = inspect_fit(of->part_template, samples, fit->fit, options);
    ++terms.shapes;
    for (std::size_t term = 0; term < energy_terms.size(); ++term) {
      terms.whole[term].push_back(fit->fit.energy.*energy_terms[term]);
      for (std::size_t part = 0; part < terms.parts.size(); ++part) {
        if (fit->fit.parts[part].present)
          terms.parts[part][term].push_back(inspection.parts[part].*energy_terms[term]);
      }
    }
  }
  const auto sort_all = [](TermValues& values) {
    for (std::vector<double>& each : values) std::ranges::sort(each);
  };
  sort_all(terms.whole);
  std::ranges::for_each(terms.parts, sort_all);
  return terms;
}

}  // namespace archetype
