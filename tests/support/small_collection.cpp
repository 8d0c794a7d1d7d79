#include "tests/support/small_collection.h"

#include <algorithm>

#include "core/generate/generate.h"

namespace archetype::test {

namespace {

TemplatePart part(const std::string& name, const Vec3& centre, const Vec3& half_extent) {
  const std::vector<std::string> labels = family_names("chairs").labels;
  TemplatePart result;
  result.name = name;
  result.label = static_cast<int>(std::ranges::find(labels, name) - labels.begin());
  result.position.mean = centre;
  result.scale.mean = half_extent;
  return result;
}

}  // namespace

void write_chairs(const std::filesystem::path& folder, std::size_t count, std::uint64_t seed) {
  GenerateOptions options;
  options.count = count;
  options.seed = seed;
  options.yaw = YawChoice::quarters;
  write_collection("chairs", options, folder, {});
}

PartTemplate chair_template() {
  PartTemplate chair;
  chair.name = "chair";
  chair.parts = {part("seat", {0, -0.1, 0}, {0.65, 0.06, 0.65}),
                 part("back", {0, 0.7, -0.6}, {0.65, 0.6, 0.06})};
  for (const double x : {-0.55, 0.55}) {
    for (const double z : {-0.55, 0.55}) chair.parts.push_back(part("leg", {x, -0.7, z}, {0.06, 0.5, 0.06}));
  }
  return chair;
}

PartTemplate drum_template() {
  PartTemplate drum;
  drum.name = "drum";
  drum.parts.resize(1);
  drum.parts[0].name = "drum";
  drum.parts[0].scale = {{0.6, 1, 0.6}, {0.1, 0.1, 0.1}};
  return drum;
}

}  // namespace archetype::test
