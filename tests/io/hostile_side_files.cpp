// Hostile templates, labels and landmarks.
#include "tests/io/hostile_corpus.h"

namespace archetype::test {

namespace {

std::string part(const std::string& keys) {
  return R"({"format":"archetype-template","version":1,"name":"t","parts":[{)" + keys + "}]}";
}
std::string replaced(const std::string& from, const std::string& to) {
  std::string text = part(R"("name":"p","position":{"mean":[0,0,0]},"scale":{"mean":[1,1,1]})");
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

std::vector<HostileFile> hostile_side_files() {
  const std::string mean = R"("mean":[0,0,0])";
  std::string many = R"({"format":"archetype-template","version":1,"name":"t","parts":[1)";
  for (int i = 0; i < 256; ++i) many += ",1";
  std::string keys;
  for (int i = 0; i < 257; ++i) keys += ",\"x" + std::to_string(i) + "\":1";
  return {
      {"empty.json", "", "not valid JSON"},
      {"prose.json", "once\nupon", "line 1, column 1: not valid JSON"},
      {"cut.json", "{\n\"format\":", "line 2, column 10: not valid JSON"},
      {"trailing.json", replaced("]}", "]}}"), "not valid JSON"},
      {"utf8.json", replaced("\"t\"", "\"\xFF\xFE\""), "not valid JSON"},
      {"deep.json", std::string(1000000, '['), "nested more than 64 levels deep"},
      {"deep_objects.json", replaced("\"t\"", "\"t\",\"x\":" + std::string(100, '[') + std::string(100, ']')),
       "nested more than 64"},
      {"array.json", "[]", "expected an object, found array"},
      {"format.json", replaced("archetype-template", "something"), "format: expected \"archetype-template\""},
      {"no_format.json", "{}", "format: the key is missing"},
      {"newer.json", replaced("\"version\":1", "\"version\":2"),
       "version: the file was written by a newer version"},
      {"version.json", replaced("\"version\":1", "\"version\":1.5"),
       "version: expected a whole number, found 1.5"},
      {"version_zero.json", replaced("\"version\":1", "\"version\":0"), "version: expected a number from 1"},
      {"up.json", replaced("\"version\":1", "\"version\":1,\"up\":\"z\""), "up: expected \"y\""},
      {"name.json", replaced("\"t\"", "7"), "name: expected a text, found number"},
      {"no_parts.json", R"({"format":"archetype-template","version":1,"name":"t"})",
       "parts: the key is missing"},
      {"many_parts.json", many + "]}", "parts: expected an array of at most 256 values, found 257 values"},
      {"part_type.json", R"({"format":"archetype-template","version":1,"name":"t","parts":[3]})",
       "parts[0]: expected an object, found number"},
      {"part_name.json", replaced("\"name\":\"p\",", ""), "parts[0].name: the key is missing"},
      {"no_position.json", part(R"("name":"p","scale":{"mean":[1,1,1]})"),
       "parts[0].position: the key is missing"},
      {"mean_size.json", replaced(mean, R"("mean":[0,0])"),
       "parts[0].position.mean: expected an array of 3 values, found 2"},
      {"mean_type.json", replaced(mean, R"("mean":[0,"0",0])"),
       "parts[0].position.mean[1]: expected a number, found string"},
      {"mean_null.json", replaced(mean, R"("mean":[0,null,0])"),
       "parts[0].position.mean[1]: expected a number, found null"},
      {"mean_huge.json", replaced(mean, R"("mean":[0,0,1e300])"),
       "parts[0].position.mean[2]: expected a number from"},
      {"mean_overflow.json", replaced(mean, R"("mean":[0,0,1e999])"), "not valid JSON"},
      {"nan.json", replaced(mean, R"("mean":[0,0,NaN])"), "not valid JSON"},
      {"stddev_zero.json", replaced(mean, mean + R"(,"stddev":[1,0,1])"),
       "parts[0].position.stddev[1]: expected a number from 1e-09"},
      {"stddev_negative.json", replaced(mean, mean + R"(,"stddev":[1,1,-1])"), "parts[0].position.stddev[2]"},
      {"scale_zero.json", replaced("[1,1,1]", "[1,0,1]"),
       "parts[0].scale.mean[1]: expected a number from 1e-09"},
      {"quaternion.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"orientation\":[0,0,0,0]"),
       "parts[0].orientation: expected a unit quaternion"},
      {"quaternion_size.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"orientation\":[1,0,0]"),
       "parts[0].orientation: expected an array of 4"},
      {"existence.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"existence\":0"),
       "parts[0].existence: expected a number from"},
      {"existence_two.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"existence\":2"),
       "parts[0].existence"},
      {"label.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"label\":-1"),
       "parts[0].label: expected a number from 0"},
      {"label_wide.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"label\":18446744073709551615"),
       "parts[0].label"},
      {"must_exist.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"must_exist\":1"),
       "parts[0].must_exist: expected true or false, found number"},
      {"features.json", replaced("\"name\":\"p\"", "\"name\":\"p\",\"features\":{\"mean\":[0]}"),
       "parts[0].features.mean: expected an array of 6"},

      {"many_keys.json", replaced("\"t\"", "\"t\"" + keys), "more than 256 keys that are not known"},

      {"empty.seg", "", "expected one label for each of the 3 elements of the shape, found 0"},
      {"fewer.seg", "1\n2\n", "found 2"},
      {"more.seg", "1\n2\n3\n4\n", "line 4: expected one label for each of the 3"},
      {"word.seg", "1\nleg\n3\n", "line 2: expected a whole number, found \"leg\""},
      {"fraction.seg", "1\n2.5\n3\n", "expected a whole number"},
      {"negative.seg", "1\n-2\n3\n", "expected a label of 0 or more, or -1 for none, found -2"},
      {"wide.seg", "1\n2147483648\n3\n", "found 2147483648"},
      {"two.seg", "1 2 3\n", "line 1: expected one label a line, found \"2 3\""},
      {"zero_labels.txt", "leg\n0\n", "line 2: expected face numbers from 1 to 3, found 0"},
      {"beyond_labels.txt", "leg\n1 2 4\n", "expected face numbers from 1 to 3, found 4"},
      {"unnamed_labels.txt", "1 2 3\n", "line 1: expected the name of a label"},
      {"word_labels.txt", "leg\n1 x\n", "line 2: expected a whole number, found \"x\""},
      {"twice_labels.txt", "leg\n1 2\nseat\n2 3\n", "line 4: face 2 has two labels"},
      {"two.vts", "1 2\n", "line 1: the line ends where a number was expected"},
      {"four.vts", "1 2 3 4\n", "expected x y z, found more: \"4\""},
      {"one.vts", "-2\n", "expected x y z, or -1 alone"},
      {"nan.vts", "1 2 nan\n", "expected a finite number"},
  };
}

}  // namespace archetype::test
