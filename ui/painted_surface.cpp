// A smooth share of pinned samples over the surface, cut where it is a half.
#include "ui/painted_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <map>

namespace archetype {
namespace {

// In distances of neighbouring samples.
constexpr float reach = 2.6F;      // of the samples that have a say at a place
constexpr float finest = 0.3F;     // side of the triangles that are cut
constexpr float thickness = 0.3F;  // samples so far above or below the surface are of another sheet
constexpr float lift = 0.04F;      // of the patch, so that the surface does not hide it
constexpr std::size_t most_triangles = 60'000;

// With the normal of the surface there, smoothed as it is drawn.
struct Corner {
  glm::vec3 at;
  glm::vec3 normal;
};
using Triangle = std::array<Corner, 3>;

Corner mix(const Corner& a, const Corner& b, float share) {
  return {glm::mix(a.at, b.at, share), glm::mix(a.normal, b.normal, share)};
}

struct Sample {
  glm::vec3 at;
  bool painted = false;  // with the label in question
};

class Patch {
 public:
  Patch(float spacing, MeshGeometry& made) : spacing_(spacing), made_(made) {}

  void add(const Triangle& triangle, std::span<const Sample> samples) {
    const glm::vec3 across = glm::cross(triangle[1].at - triangle[0].at, triangle[2].at - triangle[0].at);
    const float area = glm::length(across);
    if (!(area > 0) || !std::isfinite(area)) return;
    visit(triangle, samples, 0);
  }

 private:
  // Only where something is painted, down to triangles that are small beside the brush.
  void visit(const Triangle& t, std::span<const Sample> samples, int depth) {
    const glm::vec3 middle = (t[0].at + t[1].at + t[2].at) / 3.F;
    float radius = 0;
    for (const Corner& corner : t) radius = std::max(radius, glm::distance(corner.at, middle));
    std::vector<Sample> near;
    for (const Sample& sample : samples)
      if (glm::distance(sample.at, middle) < radius + reach * spacing_) near.push_back(sample);
    if (std::ranges::none_of(near, &Sample::painted)) return;
    std::size_t longest = 0;
    for (std::size_t side = 1; side < 3; ++side)
      if (length_of(t, side) > length_of(t, longest)) longest = side;
    constexpr int deepest = 24;
    if (length_of(t, longest) <= finest * spacing_ || depth >= deepest ||
        made_.triangle_count() > most_triangles) {
      cut(t, near);
      return;
    }
    const Corner half = mix(t[longest], t[(longest + 1) % 3], 0.5F);
    const Corner& opposite = t[(longest + 2) % 3];
    visit({t[longest], half, opposite}, near, depth + 1);
    visit({half, t[(longest + 1) % 3], opposite}, near, depth + 1);
  }

  static float length_of(const Triangle& t, std::size_t side) {
    return glm::distance(t[side].at, t[(side + 1) % 3].at);
  }

  // Above 0 where most of the samples nearby are painted, the nearest counting most.
  float excess(const Corner& corner, std::span<const Sample> samples) const {
    const float far = reach * spacing_;
    const float sheet = thickness * spacing_;
    float all = 0;
    float painted = 0;
    for (const Sample& sample : samples) {
      const glm::vec3 away = sample.at - corner.at;
      const float square = glm::dot(away, away) / (far * far);
      if (square >= 1) continue;
      const float off = glm::dot(away, corner.normal) / sheet;
      const float weight = (1 - square) * (1 - square) * std::exp(-off * off / 2);
      all += weight;
      painted += sample.painted ? weight : 0;
    }
    return all > 1e-6F ? painted / all - 0.5F : -0.5F;
  }

  void cut(const Triangle& t, std::span<const Sample> samples) {
    std::array<float, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = excess(t[i], samples);
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (values[i] > 0) kept.push_back(t[i]);
      if ((values[i] > 0) == (values[next] > 0)) continue;
      kept.push_back(mix(t[i], t[next], values[i] / (values[i] - values[next])));
    }
    for (std::size_t i = 2; i < kept.size(); ++i)
      for (const float side : {1.F, -1.F}) emit({kept[0], kept[i - 1], kept[i]}, side);
  }

  void emit(const Triangle& t, float side) {
    for (const Corner& corner : t) {
      made_.positions.push_back(corner.at + side * lift * spacing_ * corner.normal);
      made_.normals.push_back(side * corner.normal);
      made_.edge_distances.emplace_back(255, 255, 255, 0);
    }
    made_.faces.push_back(0);
  }

  float spacing_;
  MeshGeometry& made_;
};

// The bounds of what is painted, and as far as it has a say.
bool overlaps(const Triangle& t, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 least = glm::min(t[0].at, glm::min(t[1].at, t[2].at));
  const glm::vec3 most = glm::max(t[0].at, glm::max(t[1].at, t[2].at));
  return glm::all(glm::lessThanEqual(least, high)) && glm::all(glm::greaterThanEqual(most, low));
}

std::shared_ptr<const MeshGeometry> patch_of(const MeshGeometry& mesh, const PointGeometry& points,
                                             const std::vector<std::uint32_t>& painted) {
  std::vector<Sample> samples;
  for (const glm::vec3& at : points.positions) samples.push_back({at});
  glm::vec3 low(INFINITY);
  glm::vec3 high(-INFINITY);
  for (const std::uint32_t i : painted) {
    samples[i].painted = true;
    low = glm::min(low, samples[i].at);
    high = glm::max(high, samples[i].at);
  }
  const float more = reach * points.spacing;
  std::erase_if(samples, [&](const Sample& sample) {
    return glm::any(glm::lessThan(sample.at, low - 2 * more)) ||
           glm::any(glm::greaterThan(sample.at, high + 2 * more));
  });
  auto made = std::make_shared<MeshGeometry>();
  Patch patch(points.spacing, *made);
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = {mesh.positions[3 * i + k], mesh.normals[3 * i + k]};
    if (overlaps(triangle, low - more, high + more)) patch.add(triangle, samples);
  }
  made->face_count = 1;
  if (!made->positions.empty()) made->low = made->high = made->positions.front();
  for (const glm::vec3& at : made->positions) {
    made->low = glm::min(made->low, at);
    made->high = glm::max(made->high, at);
  }
  return made;
}

}  // namespace

std::vector<PaintedPatch> painted_patches(const MeshGeometry& mesh, const PointGeometry& samples,
                                          std::span<const PinnedLabel> pinned) {
  std::vector<PaintedPatch> patches;
  if (!(samples.spacing > 0)) return patches;
  std::map<std::int16_t, std::vector<std::uint32_t>> by_label;
  for (const PinnedLabel& pin : pinned)
    if (pin.sample < samples.positions.size()) by_label[pin.label].push_back(pin.sample);
  for (const auto& [label, painted] : by_label) {
    auto geometry = patch_of(mesh, samples, painted);
    if (geometry->triangle_count() > 0) patches.push_back({label, std::move(geometry)});
  }
  return patches;
}

}  // namespace archetype
