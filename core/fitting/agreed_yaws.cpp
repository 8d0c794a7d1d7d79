// Densities on a grid, and votes of the nearest until nothing changes.
#include "core/fitting/agreed_yaws.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/model/shape_fit.h"

namespace archetype {

namespace {

constexpr int cells = 8;           // along each axis of the bounds
constexpr double blur = 0.8;       // standard deviation, in cells
constexpr int blur_reach = 2;      // cells
constexpr std::size_t voters = 8;  // references that are asked about a shape: those most like it
constexpr std::size_t fewest_references = 4;
constexpr int most_rounds = 50;

// What a whole likeness is worth in energy. (Vases turn wrongly from about 35, stools below 13.)
constexpr double vote_weight = 20;
// A shape turns for a template that fits it clearly better, and not where its spout will do for a handle.
constexpr double turning_cost = 0.1;
// Energies differ by less.
constexpr double hopeless = 2;

// Densities of one yaw: by cell, and by the axis (x, y, z) of the normal.
class FacingGrid {
 public:
  // u: in [-1, 1] within the bounds. normal: unit.
  void add(const Vec3& u, const Vec3& normal) {
    std::array<int, 3> cell{};
    Vec3 beyond;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = std::clamp((u[axis] + 1) / 2 * (cells - 1), 0.0, cells - 1 - 1e-6);
      cell[static_cast<std::size_t>(axis)] = static_cast<int>(at);
      beyond[axis] = at - std::floor(at);
    }
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      std::size_t index = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const int far = (corner >> axis) & 1;
        weight *= far != 0 ? beyond[axis] : 1 - beyond[axis];
        index = index * cells + static_cast<std::size_t>(cell[static_cast<std::size_t>(axis)] + far);
      }
      for (int axis = 0; axis < 3; ++axis)
        values_[index * 3 + static_cast<std::size_t>(axis)] +=
            static_cast<float>(weight * normal[axis] * normal[axis]);
    }
  }

  FacingPicture picture() && {
    for (const std::size_t stride : {3 * cells * cells, 3 * cells, 3}) blur_along(stride);
    double sum = 0;
    for (const float value : values_) sum += value;
    for (float& value : values_) value = static_cast<float>(std::sqrt(value / std::max(sum, 1e-30)));
    return std::move(values_);
  }

 private:
  void blur_along(std::size_t stride) {
    FacingPicture blurred(values_.size(), 0.0F);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const int at = static_cast<int>(i / stride % cells);
      for (int step = -blur_reach; step <= blur_reach; ++step) {
        if (at + step < 0 || at + step >= cells) continue;
        const auto to = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) +
                                                 step * static_cast<std::ptrdiff_t>(stride));
        blurred[to] += values_[i] * static_cast<float>(std::exp(-0.5 * step * step / (blur * blur)));
      }
    }
    values_ = std::move(blurred);
  }

  FacingPicture values_ = FacingPicture(std::size_t{3} * cells * cells * cells, 0.0F);
};

double likeness(const FacingPicture& a, const FacingPicture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i] * b[i]);
  return sum;
}

}  // namespace

std::array<FacingPicture, 4> facing_pictures(const ShapeSamples& samples) {
  // Stretched to the bounds, a bench looks like a chair.
  Bounds bounds;
  for (const Vec3& p : samples.points) bounds.add(p);
  const Vec3 half = bounds.half_extent().cwiseMax(1e-6);
  std::array<FacingPicture, 4> pictures;
  for (int yaw = 0; yaw < 4; ++yaw) {
    FacingGrid grid;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vec3 u = (samples.points[i] - bounds.centre()).cwiseQuotient(half);
      grid.add(turn_quarters(u, -yaw), turn_quarters(samples.normals[i], -yaw));
    }
    pictures[static_cast<std::size_t>(yaw)] = std::move(grid).picture();
  }
  return pictures;
}

void add_cost_of_turning(std::array<double, 4>& costs, std::optional<int> known) {
  for (int yaw = 0; yaw < 4; ++yaw) {
    if (known && yaw != *known) costs[static_cast<std::size_t>(yaw)] += turning_cost;
  }
}

AgreedYaws::AgreedYaws(std::span<const ShapeSamples> references,
                       std::span<const std::array<double, 4>> energies, const JobControl& control) {
  if (references.size() != energies.size()) throw PreconditionError("references need the energies of fits");
  const auto cheapest = [](const std::array<double, 4>& each) {
    return static_cast<std::size_t>(std::ranges::min_element(each) - each.begin());
  };
  std::vector<std::array<FacingPicture, 4>> pictures;
  std::vector<std::size_t> yaws;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (control.cancelled()) return;
    pictures.push_back(facing_pictures(references[i]));
    yaws.push_back(cheapest(energies[i]));
    references_.push_back(pictures[i][yaws[i]]);
  }
  // One after the other, so that two that disagree do not change places for ever.
  bool turned = true;
  for (int round = 0; turned && round < most_rounds; ++round) {
    turned = false;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      if (control.cancelled()) return;
      std::array<double, 4> sum = costs(pictures[i], i);
      for (std::size_t yaw = 0; yaw < 4; ++yaw) sum[yaw] += energies[i][yaw];
      const std::size_t best = cheapest(sum);
      if (sum[best] >= sum[yaws[i]]) continue;
      yaws[i] = best;
      references_[i] = pictures[i][best];
      turned = true;
    }
  }
}

// By the mean likeness, in each yaw, to the references that are most like the shape in any yaw.
std::array<double, 4> AgreedYaws::costs(const std::array<FacingPicture, 4>& pictures,
                                        std::size_t without) const {
  if (references_.size() < fewest_references) return {};
  std::vector<std::array<double, 4>> all;
  for (std::size_t j = 0; j < references_.size(); ++j) {
    if (j == without) continue;
    std::array<double, 4>& each = all.emplace_back();
    for (std::size_t yaw = 0; yaw < 4; ++yaw) each[yaw] = likeness(pictures[yaw], references_[j]);
  }
  std::ranges::stable_sort(all, std::greater{}, [](const auto& each) { return std::ranges::max(each); });
  all.resize(std::min(all.size(), voters));
  std::array<double, 4> votes{};
  for (const auto& each : all) {
    for (std::size_t yaw = 0; yaw < 4; ++yaw) votes[yaw] += each[yaw] / static_cast<double>(all.size());
  }
  std::array<double, 4> result{};
  for (std::size_t yaw = 0; yaw < 4; ++yaw) {
    result[yaw] = vote_weight * (std::ranges::max(votes) - votes[yaw]);
    if (result[yaw] > hopeless) result[yaw] = std::numeric_limits<double>::infinity();
  }
  return result;
}

std::array<double, 4> AgreedYaws::costs(const ShapeSamples& samples) const {
  return costs(facing_pictures(samples), std::numeric_limits<std::size_t>::max());
}

}  // namespace archetype
