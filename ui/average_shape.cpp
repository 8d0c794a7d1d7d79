#include "ui/average_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/random.h"
#include "core/io/project.h"
#include "render/convert.h"

namespace archetype {
namespace {

constexpr double cell = 0.1;  // normalised units: about the distance of neighbouring samples
constexpr double least_share = 0.1;
// A violet that no part has, as far from the backdrop as it can be.
constexpr Rgb dark_faint{74, 66, 92};
constexpr Rgb dark_ink{224, 204, 255};
constexpr Rgb light_faint{206, 198, 222};
constexpr Rgb light_ink{92, 58, 150};

struct Cell {
  Vec3 sum = Vec3::Zero();
  std::size_t samples = 0;
  std::size_t shapes = 0;
  std::size_t last_shape = 0;  // counted from 1
};
using Cells = std::map<std::array<int, 3>, Cell>;

void add_shape(Cells& cells, const ShapeSamples& samples, int yaw_quarters, std::size_t number) {
  for (const Vec3& p : samples.points) {
    const Vec3 q = turn_quarters(p, -yaw_quarters);
    Cell& here =
        cells[{static_cast<int>(std::floor(q.x() / cell)), static_cast<int>(std::floor(q.y() / cell)),
               static_cast<int>(std::floor(q.z() / cell))}];
    here.sum += q;
    ++here.samples;
    if (here.last_shape != number) ++here.shapes;
    here.last_shape = number;
  }
}

Rgb mixed(const Rgb& from, const Rgb& to, double share) {
  Rgb result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround((1 - share) * from[k] + share * to[k]));
  return result;
}

AverageShape drawn(const Cells& cells, std::size_t shapes) {
  std::vector<const Cell*> kept;
  const double least = std::max(1.0, least_share * static_cast<double>(shapes));
  for (const auto& [place, each] : cells)
    if (static_cast<double>(each.shapes) >= least) kept.push_back(&each);
  // Nothing hides anything in a ghost: what most shapes have is drawn last.
  std::ranges::stable_sort(kept, {}, [](const Cell* each) { return each->shapes; });
  auto points = std::make_shared<PointGeometry>();
  auto over_dark = std::make_shared<Colours>();
  auto over_light = std::make_shared<Colours>();
  const double most = kept.empty() ? 1 : static_cast<double>(kept.back()->shapes);
  for (const Cell* each : kept) {
    points->positions.emplace_back(to_glm(Vec3(each->sum / static_cast<double>(each->samples))));
    // Of what the most of them have, or shapes of many kinds would leave a faint cloud; and a root, or what
    // half as many have would hardly be seen.
    const double share = std::sqrt(static_cast<double>(each->shapes) / most);
    over_dark->push_back(mixed(dark_faint, dark_ink, share));
    over_light->push_back(mixed(light_faint, light_ink, share));
  }
  points->spacing = static_cast<float>(cell);
  return {points, over_dark, over_light, shapes, 0};
}

}  // namespace

std::optional<AverageShape> make_average_shape(const AverageRequest& request, const JobControl& control) {
  const Project project = Project::open(request.project);
  const std::vector<ShapeId> ids = project.shape_ids();
  if (ids.empty()) return std::nullopt;
  Cells cells;
  std::size_t number = 0;
  for (const std::size_t i : random_subset(ids.size(), most_averaged_shapes, 1)) {
    if (control.cancelled()) return std::nullopt;
    const std::optional<FitRecord> fit = project.fit(ids[i]);
    add_shape(cells, project.samples(ids[i]), fit ? fit->fit.yaw_quarters : 0, ++number);
  }
  AverageShape result = drawn(cells, number);
  result.revision = request.revision;
  return result;
}

}  // namespace archetype
