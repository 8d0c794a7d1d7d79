#include <doctest/doctest.h>

#include <ctime>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/io/template_file.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using namespace archetype::test;

namespace {

const char* const smallest =
    R"({"format":"archetype-template","version":1,"name":"chair","parts":[
        {"name":"seat","position":{"mean":[0,0.1,0]},"scale":{"mean":[0.6,0.08,0.6]}},
        {"name":"leg","position":{"mean":[0,-1,0]},"scale":{"mean":[0.1,0.5,0.1]}}]})";

PartTemplate random_template(std::uint64_t seed) {
  RandomStream random(seed);
  PartTemplate result;
  result.name = "Stuhl \xC3\xA4 \"quoted\" \\ \n";
  result.extra_json = R"({"author":{"name":"x","tags":[1,2.5,null,true]},"zeta":1e-30})";
  for (int i = 0; i < 5; ++i) {
    TemplatePart part;
    part.name = "part";  // twice the same name is allowed
    part.label = i / 2;
    part.must_exist = i % 2 == 0;
    part.orientation = Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal());
    part.orientation.normalize();
    for (int axis = 0; axis < 3; ++axis) {
      part.position.mean[axis] = random.normal();
      part.position.stddev[axis] = random.uniform(1e-6, 2);
      part.scale.mean[axis] = random.uniform(1e-6, 2);
      part.scale.stddev[axis] = random.uniform(1e-6, 2);
    }
    part.has_features = i > 2;
    if (part.has_features) {
      for (double& x : part.features.mean) x = random.normal();
      for (double& x : part.features.stddev) x = random.uniform(1e-6, 2);
    }
    part.existence = 1 - random.uniform();
    part.colour = i - 1;
    if (i < 2) part.mirror = {7, i == 0 ? 0 : 2};
    if (i == 1) part.extra_json = R"({"colour":"red"})";
    result.parts.push_back(part);
  }
  return result;
}

}  // namespace

TEST_CASE("a template file may leave out what has a default") {
  const PartTemplate chair = parse_template(smallest, "t.json");
  CHECK(chair.name == "chair");
  REQUIRE(chair.parts.size() == 2);
  CHECK(chair.parts[0].position.mean == Vec3(0, 0.1, 0));
  CHECK(chair.parts[0].position.stddev == Gaussian3{}.stddev);
  CHECK(chair.parts[0].scale.stddev == TemplatePart{}.scale.stddev);
  CHECK(chair.parts[0].orientation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
  CHECK_FALSE(chair.parts[0].must_exist);
  CHECK_FALSE(chair.parts[0].has_features);
  CHECK(chair.parts[0].existence == 1.0);
  CHECK(chair.parts[1].label == 1);  // its place in the list
  CHECK(chair.extra_json.empty());
}

TEST_CASE("templates round trip to the bit, unknown keys included") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const PartTemplate before = random_template(seed);
    const std::string text = format_template(before);
    const PartTemplate after = parse_template(text, "t.json");
    CHECK(after == before);
    CHECK(format_template(after) == text);
  }
}

TEST_CASE("a quaternion that is not quite of unit length is normalised, zero is refused") {
  std::string text = smallest;
  text.replace(text.find("\"position\""), 0, R"("orientation":[0,3,0,4],)");
  CHECK(parse_template(text, "t.json").parts[0].orientation.coeffs() == Eigen::Vector4d(0.6, 0, 0.8, 0));
  text.replace(text.find("[0,3,0,4]"), 9, "[0,0,0,0]");
  CHECK_THROWS_WITH_AS(parse_template(text, "t.json"), doctest::Contains("t.json, parts[0].orientation"),
                       InputError);
}

TEST_CASE("writing a template replaces the file as a whole and never leaves one that cannot be read") {
  const ScratchFolder folder;
  const auto path = folder.path() / "t.json";
  const PartTemplate good = random_template(1);
  write_template(path, good);
  CHECK(read_template(path) == good);

  PartTemplate bad = good;
  bad.parts[2].scale.mean[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(write_template(path, bad), PreconditionError);
  bad = good;
  bad.extra_json = "[not an object";
  CHECK_THROWS_AS(write_template(path, bad), PreconditionError);
  CHECK(read_template(path) == good);
  CHECK_THROWS_AS(write_template(folder.path() / "missing" / "t.json", good), FileError);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a known key in extra_json never overrides the template's own value") {
  PartTemplate part_template = random_template(2);
  part_template.extra_json = R"({"name":"wrong","other":1})";
  const PartTemplate after = parse_template(format_template(part_template), "t.json");
  CHECK(after.name == part_template.name);
  CHECK(after.extra_json == R"({"other":1})");
}

TEST_CASE("very many keys below an unknown one are kept in a time that grows with their number") {
  std::string text = smallest;
  std::string keys;
  for (int i = 0; i < 200000; ++i) keys += (i == 0 ? "\"k" : ",\"k") + std::to_string(i) + "\":0";
  text.replace(text.find("\"name\""), 0, "\"x\":{" + keys + "},");
  const std::clock_t begin = std::clock();
  const PartTemplate before = parse_template(text, "t.json");
  CHECK(parse_template(format_template(before), "t.json") == before);
  CHECK(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC < 10);  // quadratic: minutes
}

TEST_CASE("a link or colour that is none is refused with its place") {
  const auto with = [](const std::string& key) {
    return R"({"format":"archetype-template","version":1,"name":"t","parts":[{"name":"p",)" + key +
           R"(,"position":{"mean":[0,0,0]},"scale":{"mean":[1,1,1]}}]})";
  };
  CHECK(parse_template(with(R"("mirror_link":{"pair":3,"axis":"z"})"), "t").parts[0].mirror ==
        MirrorLink{3, 2});
  for (const char* key : {R"("mirror_link":{"pair":0,"axis":"x"})", R"("mirror_link":{"pair":1,"axis":"y"})",
                          R"("mirror_link":{"pair":1})", R"("mirror_link":1)", R"("palette_colour":-1)",
                          R"("palette_colour":21)"})
    CHECK_THROWS_AS(parse_template(with(key), "t"), InputError);
}
