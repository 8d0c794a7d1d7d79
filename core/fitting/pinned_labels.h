// What corrections by hand mean for the fit of one template to one shape.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/model/part_template.h"
#include "core/model/shape_correction.h"

namespace archetype {

// A sample that has this label whatever it costs.
struct PinnedLabel {
  std::uint32_t sample = 0;
  std::int16_t label = 0;  // a part index, or null_label
  friend bool operator==(const PinnedLabel&, const PinnedLabel&) = default;
};

// The pinned samples of a shape of `samples` samples, for a template: ascending, each once. Those of parts
// that the template does not have are left out; of several parts of one name the first has them.
std::vector<PinnedLabel> pinned_labels(const PinnedParts& pinned, const PartTemplate& part_template,
                                       std::size_t samples);

// What the yaws cost (FitOptions::yaw_costs) where one of them is pinned.
std::array<double, 4> pinned_yaw_costs(std::array<double, 4> costs, const ShapeCorrection& correction);

// Whether a shape may take each of the templates: all of them, unless one has the name that is pinned.
std::vector<bool> allowed_templates(const ShapeCorrection& correction,
                                    std::span<const std::string> template_names);

// Whether all that the correction names is there: its template, and each part in one of them at least.
bool can_be_heeded(const ShapeCorrection& correction, std::span<const PartTemplate> templates);

}  // namespace archetype
