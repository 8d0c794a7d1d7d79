#include "core/session/fit_alternatives.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/fitting/fit_template.h"
#include "core/fitting/template_choice.h"

namespace archetype {

std::optional<std::vector<FitAlternative>> fit_alternatives(std::span<const PartTemplate> templates,
                                                            const ShapeSamples& samples,
                                                            const PinnedParts& pinned,
                                                            const FitOptions& options,
                                                            const JobControl& control) {
  std::vector<FitAlternative> alternatives;
  for (std::size_t t = 0; t < templates.size(); ++t) {
    if (templates[t].parts.empty()) continue;
    const std::vector<PinnedLabel> labels = pinned_labels(pinned, templates[t], samples.size());
    for (std::size_t yaw = 0; yaw < 4; ++yaw) {
      FitOptions at_yaw = options;
      at_yaw.yaw_costs.fill(std::numeric_limits<double>::infinity());
      at_yaw.yaw_costs[yaw] = 0;
      FitRecording recording;
      std::optional<ShapeFit> fit;
      try {
        fit = fit_template(templates[t], samples, at_yaw, control, &recording, labels);
      } catch (const NumericError&) {  // this one cannot be had
        continue;
      }
      if (!fit || control.cancelled()) return std::nullopt;
      if (!std::isfinite(fit->energy.total())) continue;
      const double choice = choice_energy(*fit, templates[t], samples, options);
      alternatives.push_back({t, std::move(*fit), choice, std::move(recording.steps)});
    }
  }
  return alternatives;
}

}  // namespace archetype
