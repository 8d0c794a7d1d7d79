// A few alternations of matching and deforming for each solid.
#include "core/fitting/choose_solids.h"

#include "core/fitting/energy.h"

namespace archetype {

namespace {

constexpr int steps = 3;

// What each part contributes to the energy by distances and by its deformation.
struct PartEnergy {
  double data = 0;
  double deformation = 0;
};

std::vector<PartEnergy> part_energies(const MatchedShape& shape, const PartTemplate& part_template,
                                      std::span<const Box> boxes, const FitOptions& options) {
  const double scale = 1 / (shape.unit * shape.unit);
  const double shape_weight = scale / static_cast<double>(shape.points.size());
  const double template_weight = scale / static_cast<double>(shape.surface->local.size());
  std::vector<PartEnergy> energies(boxes.size());
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (shape.labels[i] == null_label) continue;
    const auto k = static_cast<std::size_t>(shape.labels[i]);
    const Vec3 match = boxes[k].to_world(shape.matches->on_template[i]);
    energies[k].data += shape_weight * (match - shape.points[i]).squaredNorm();
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    energies[k].deformation = options.alpha * part_deformation(part_template.parts[k], boxes[k], options);
    for (auto t = shape.surface->begins[k]; t < shape.surface->begins[k + 1]; ++t) {
      const auto i = shape.matches->on_shape[t];
      if (i == Correspondences::none) break;
      const Vec3 on_template = boxes[k].to_world(on_solid(boxes[k].solid, shape.surface->local[t]));
      energies[k].data += template_weight * (on_template - shape.points[i]).squaredNorm();
    }
  }
  return energies;
}

}  // namespace

std::optional<std::vector<Box>> choose_solids(const MatchedShape& shape, const PartTemplate& part_template,
                                              std::span<const Box> boxes, const FitOptions& options,
                                              const MatchBoxes& match) {
  if (options.round_share <= 0) return std::nullopt;
  std::vector<Box> chosen(boxes.begin(), boxes.end());
  std::vector<PartEnergy> least = part_energies(shape, part_template, boxes, options);
  for (PartEnergy& energy : least) energy.data *= options.round_share;
  bool changed = false;
  for (const Solid solid : round_solids) {
    Correspondences matches = *shape.matches;
    const MatchedShape matched{shape.points, shape.labels, shape.surface, &matches, shape.unit};
    std::vector<Box> tried(boxes.begin(), boxes.end());
    for (Box& box : tried) box.solid = solid;
    for (int step = 0; step < steps; ++step) {
      match(tried, matches);
      deformation_step(matched, part_template, options, tried);
    }
    match(tried, matches);
    const std::vector<PartEnergy> found = part_energies(matched, part_template, tried, options);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const bool present = tried[k].solid == solid;  // parts without samples went back to their mean box
      if (!present || boxes[k].solid != Solid::box) continue;
      if (found[k].data + found[k].deformation >= least[k].data + least[k].deformation) continue;
      least[k] = found[k];
      chosen[k] = tried[k];
      changed = true;
    }
  }
  if (!changed) return std::nullopt;
  return chosen;
}

}  // namespace archetype
