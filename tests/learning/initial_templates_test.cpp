#include "core/learning/initial_templates.h"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "core/learning/mirror_symmetry.h"
#include "core/model/shape_fit.h"
#include "tests/support/made_shapes.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// Plain chairs, and some with arms.
InitialShapes chairs(std::size_t plain, std::size_t armed, int points = 300) {
  InitialShapes shapes;
  for (std::size_t i = 0; i < plain + armed; ++i) {
    GenerateOptions options;
    options.styles = {i < plain ? "plain" : "arms"};
    const MadeShape made = make_shape("chairs", options, i, points);
    shapes.scored.push_back(shapes.samples.size());
    shapes.names.push_back(made.generated.name);
    shapes.samples.push_back(made.samples);
  }
  shapes.segmented = shapes.scored;
  return shapes;
}

bool same(const std::vector<InitialTemplate>& a, const std::vector<InitialTemplate>& b) {
  return std::ranges::equal(a, b, [](const InitialTemplate& x, const InitialTemplate& y) {
    return x.part_template == y.part_template && x.mean_energy == y.mean_energy && x.score == y.score;
  });
}

// Beside the seat and above it.
bool is_arm(const TemplatePart& part) {
  const Vec3& p = part.position.mean;
  return std::abs(p.x()) > 0.55 && p.y() > 0.1 && p.y() < 0.9 && part.scale.mean.z() > 0.3;
}

}  // namespace

TEST_CASE("arms that some chairs have become parts that not every chair has") {
  const auto found = initial_templates(chairs(6, 5, 300), {}, 2, {});
  REQUIRE(found);
  REQUIRE_FALSE(found->empty());
  const PartTemplate& best = found->front().part_template;
  const auto arms = std::ranges::count_if(best.parts, is_arm);
  CHECK(arms == 2);
  for (const TemplatePart& part : best.parts) {
    if (!is_arm(part)) continue;
    CHECK(part.existence < 0.6);
    CHECK_FALSE(part.must_exist);
  }
}

TEST_CASE("the best comes first, parts are named, and threads do not matter") {
  const InitialShapes shapes = chairs(4, 0, 200);
  InitialTemplateOptions options;
  options.candidates = 3;
  const auto found = initial_templates(shapes, options, 1, {});
  REQUIRE(found);
  CHECK(found->size() == 3);
  CHECK(std::ranges::is_sorted(*found, {}, &InitialTemplate::score));
  for (const InitialTemplate& candidate : *found) {
    const auto& parts = candidate.part_template.parts;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      CHECK(parts[k].name == "part " + std::to_string(k + 1));
      CHECK(parts[k].label == static_cast<int>(k));
    }
  }
  CHECK(same(*found, *initial_templates(shapes, options, 2, {})));
  CHECK(same(*found, *initial_templates(shapes, options, 8, {})));
}

TEST_CASE("candidates of one shape that is there several times are those of one, also when it is turned") {
  InitialShapes shapes = chairs(1, 0, 200);
  const std::size_t of_one = initial_templates(shapes, {}, 2, {})->size();
  for (int copy = 0; copy < 2; ++copy) {
    shapes.names.emplace_back("copy");
    shapes.samples.push_back(shapes.samples.front());
    shapes.segmented.push_back(shapes.segmented.size());
  }
  for (Vec3& p : shapes.samples[1].points) p = turn_quarters(p, 1);
  for (Vec3& n : shapes.samples[1].normals) n = turn_quarters(n, 1);
  std::swap(shapes.samples[1].features_x, shapes.samples[1].features_z);
  CHECK(initial_templates(shapes, {}, 2, {})->size() == of_one);
  CHECK(of_one >= 1);
  CHECK(of_one <= 2);  // cut into boxes, and with round parts
}

TEST_CASE("shapes are cut in both ways, and the best of each is suggested") {
  InitialShapes shapes;
  for (std::size_t i = 0; i < 3; ++i) {
    GenerateOptions options;
    options.styles = {"table"};
    const MadeShape made = make_shape("lamps", options, i, 300);
    shapes.scored.push_back(i);
    shapes.names.push_back(made.generated.name);
    shapes.samples.push_back(made.samples);
  }
  shapes.segmented = shapes.scored;
  InitialTemplateOptions options;
  options.candidates = 4;
  const auto found = initial_templates(shapes, options, 2, {});
  REQUIRE(found);
  REQUIRE(found->size() == 4);
  CHECK(std::ranges::is_sorted(*found, {}, &InitialTemplate::score));
  const auto of_rounded = [](const InitialTemplate& each) {
    return each.part_template.name.find("rounded, ") != std::string::npos;
  };
  CHECK(std::ranges::count_if(*found, of_rounded) == 2);
  // A shade is one round part; into boxes it is cut as staves.
  const auto parts = [&](bool rounded) {
    std::size_t sum = 0;
    for (const InitialTemplate& each : *found)
      if (of_rounded(each) == rounded) sum += each.part_template.parts.size();
    return sum;
  };
  CHECK(parts(true) < parts(false));
  const auto templates_of = [](const std::vector<InitialTemplate>& all) {
    std::vector<PartTemplate> result;
    for (const InitialTemplate& each : all) result.push_back(each.part_template);
    return result;
  };
  options.candidates = 1;
  const auto one = initial_templates(shapes, options, 2, {});
  CHECK(templates_of(*one) == std::vector{found->front().part_template});
}

TEST_CASE("what is called joined has more parts than its shape was cut into") {
  InitialShapes shapes;
  for (std::size_t i = 0; i < 3; ++i) {  // one of them scores better if it is only scored a second time
    const MadeShape made = make_shape("chairs", {}, i, 500);
    shapes.segmented.push_back(i);
    shapes.names.push_back(made.generated.name);
    shapes.samples.push_back(made.samples);
  }
  shapes.scored = shapes.segmented;
  const InitialTemplateOptions options;
  const auto found = initial_templates(shapes, options, 2, {});
  REQUIRE(found);
  for (const InitialTemplate& each : *found) {
    const std::string& name = each.part_template.name;
    CAPTURE(name);
    std::size_t shape = 0;
    while (!name.ends_with("from " + shapes.names.at(shape))) ++shape;
    SegmentationOptions segmentation = options.segmentation;
    segmentation.solids =
        name.find("rounded, ") == std::string::npos ? RegionSolids::boxes : RegionSolids::any;
    const std::size_t cut_into = segment_shape(shapes.samples[shape], segmentation, {})->boxes.size();
    const bool joined = name.starts_with("joined, ");
    CHECK(
        (joined ? each.part_template.parts.size() > cut_into : each.part_template.parts.size() == cut_into));
  }
}

TEST_CASE("cancelling returns at once") {
  const InitialShapes shapes = chairs(8, 5);
  std::stop_source source;
  JobControl control;
  control.stop = source.get_token();
  std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    source.request_stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  CHECK_FALSE(initial_templates(shapes, {}, 2, control));
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
}

TEST_CASE("a mirrored box is its mirror image, and a pair of parts is made exactly symmetric") {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
  const Box box{{1, 2, 3}, {0.5, 0.2, 0.1}, turned};
  for (const int axis : {0, 2}) {
    const Box image = mirrored(box, axis);
    Vec3 corner = box.to_world({1, 1, 1});
    corner[axis] = -corner[axis];
    CHECK((image.to_local(corner).cwiseAbs() - Vec3::Ones()).norm() < 1e-9);
    CHECK(box_distance(mirrored(image, axis), box) < 1e-12);
  }
  PartTemplate pair;
  pair.parts.resize(2);
  pair.parts[0].position.mean = {0.52, 1, 0};
  pair.parts[1].position.mean = {-0.48, 1, 0};
  mirror_parts(pair, 0);
  CHECK(pair.parts[0].position.mean.isApprox(Vec3(0.5, 1, 0)));
  CHECK(pair.parts[1].position.mean.isApprox(Vec3(-0.5, 1, 0)));
}
