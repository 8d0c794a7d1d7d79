#include "core/session/nearest_shapes.h"

#include <algorithm>
#include <cmath>

namespace archetype {
namespace {

constexpr double absent_distance = 4;     // in standard deviations
constexpr double farthest = 1000;         // of a parameter: more than that says nothing more
constexpr double smallest_stddev = 1e-6;  // templates of strangers may have zeros

double deviations(double value, double mean, double stddev) {
  const double z = (value - mean) / std::max(stddev, smallest_stddev);
  return std::isfinite(z) ? std::clamp(z, -farthest, farthest) : farthest;
}

struct Sum {
  double squares = 0;
  std::size_t count = 0;
  void add(double difference) {
    squares += difference * difference;
    ++count;
  }
};

void add_wished(Sum& sum, const TemplatePart& part, const PartValues& values, const PartWish& wish) {
  if (is_any(wish)) return;
  const auto parameters = part_parameters(part, values.box);
  for (std::size_t i = 0; i < wish.size(); ++i)
    if (wish[i]) sum.add(values.present ? parameters[i] - *wish[i] : absent_distance);
}

void add_from_mean(Sum& sum, const TemplatePart& part, const PartValues& values) {
  if (!values.present) return;
  for (const double parameter : part_parameters(part, values.box)) sum.add(parameter);
}

}  // namespace

bool is_any(const PartWish& wish) {
  return std::ranges::none_of(wish, [](const auto& value) { return value.has_value(); });
}

std::array<double, part_parameter_count> part_parameters(const TemplatePart& part, const Box& fitted) {
  std::array<double, part_parameter_count> parameters{};
  for (int axis = 0; axis < 3; ++axis) {
    parameters[static_cast<std::size_t>(axis)] =
        deviations(fitted.centre[axis], part.position.mean[axis], part.position.stddev[axis]);
    parameters[static_cast<std::size_t>(axis + 3)] =
        deviations(fitted.half_extent[axis], part.scale.mean[axis], part.scale.stddev[axis]);
  }
  return parameters;
}

PartTemplate wished_template(const PartTemplate& part_template, std::span<const PartWish> wishes) {
  PartTemplate wished = part_template;
  for (std::size_t p = 0; p < std::min(wishes.size(), wished.parts.size()); ++p) {
    TemplatePart& part = wished.parts[p];
    for (int axis = 0; axis < 3; ++axis) {
      const PartWish& wish = wishes[p];
      part.position.mean[axis] +=
          wish[static_cast<std::size_t>(axis)].value_or(0) * part.position.stddev[axis];
      const double half = part.scale.mean[axis] +
                          wish[static_cast<std::size_t>(axis + 3)].value_or(0) * part.scale.stddev[axis];
      part.scale.mean[axis] = std::max(half, 1e-3);
    }
  }
  return wished;
}

std::vector<NearShape> nearest_shapes(const FitTable& table, std::size_t part_template,
                                      std::span<const PartWish> wishes, std::size_t count) {
  if (part_template >= table.templates.size()) return {};
  const std::vector<TemplatePart>& parts = table.templates[part_template].part_template.parts;
  const std::size_t wished = std::min(wishes.size(), parts.size());
  const bool any = std::ranges::all_of(wishes.first(wished), is_any);
  struct Found {
    NearShape shape;
    double energy;
  };
  std::vector<Found> found;
  for (const FitTableRow& row : table.rows) {
    if (row.part_template != part_template) continue;
    const std::span<const PartValues> values = table.parts_of(row);
    Sum sum;
    for (std::size_t p = 0; p < (any ? parts.size() : wished); ++p) {
      if (any)
        add_from_mean(sum, parts[p], values[p]);
      else
        add_wished(sum, parts[p], values[p], wishes[p]);
    }
    const double distance =
        sum.count > 0 ? std::sqrt(sum.squares / static_cast<double>(sum.count)) : farthest;
    const double energy = row.summary.energy.total();
    found.push_back({{row.summary.shape, distance}, std::isfinite(energy) ? energy : 1e300});
  }
  const auto nearer = [](const Found& a, const Found& b) {
    if (a.shape.distance != b.shape.distance) return a.shape.distance < b.shape.distance;
    return a.energy != b.energy ? a.energy < b.energy : a.shape.shape < b.shape.shape;
  };
  const std::size_t taken = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(taken), found.end(), nearer);
  std::vector<NearShape> nearest;
  for (std::size_t i = 0; i < taken; ++i) nearest.push_back(found[i].shape);
  return nearest;
}

}  // namespace archetype
