#include "core/geometry/upright.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/generate/generate.h"
#include "core/geometry/sample_shape.h"

using namespace archetype;

namespace {

struct Collection {
  std::vector<UprightLook> looks;
  std::vector<UpAxis> truth;
};

Collection collection(const std::string& family, const std::vector<UpAxis>& ups, std::size_t count) {
  GenerateOptions options;
  options.ups = ups;
  options.yaw = YawChoice::quarters;
  Collection result;
  for (std::size_t i = 0; i < count; ++i) {
    const GeneratedShape shape = generate_shape(family, options, i);
    result.looks.push_back(look_upright(sample_shape(shape.mesh, {{i, 0}}, {.points = 400})));
    result.truth.push_back(shape.up);
  }
  return result;
}

double right_share(const Collection& shapes) {
  const auto ups = decide_upright(shapes.looks, {});
  double right = 0;
  for (std::size_t i = 0; i < ups.size(); ++i) right += ups[i] == shapes.truth[i];
  return right / static_cast<double>(ups.size());
}

}  // namespace

TEST_CASE("a collection that stands upright stays so") {
  for (const std::string& family : families()) CHECK(right_share(collection(family, {UpAxis::y}, 30)) >= 0.9);
}

TEST_CASE("single shapes that lie are raised with the others") {
  const std::vector<UpAxis> mostly_y{UpAxis::y, UpAxis::y, UpAxis::y, UpAxis::z, UpAxis::minus_z, UpAxis::x};
  for (const std::string family : {"chairs", "planes", "tables"})
    CHECK(right_share(collection(family, mostly_y, 60)) >= 0.85);
}

TEST_CASE("collections that all lie the same way are raised together") {
  for (const std::string& family : families()) CHECK(right_share(collection(family, {UpAxis::z}, 30)) >= 0.9);
}

TEST_CASE("empty, single and cancelled decisions") {
  CHECK(decide_upright({}, {}).empty());
  CHECK(decide_upright(collection("tables", {UpAxis::y}, 1).looks, {}).size() == 1);
  std::stop_source source;
  source.request_stop();
  CHECK(decide_upright(collection("tables", {UpAxis::y}, 2).looks, {source.get_token(), {}}).empty());
}
