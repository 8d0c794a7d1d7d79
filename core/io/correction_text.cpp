#include "core/io/correction_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/json_input.h"

namespace archetype {

using Json = nlohmann::json;

namespace {

constexpr std::array marks{ShapeMark::none, ShapeMark::outlier, ShapeMark::learn};
constexpr std::size_t most_pinned_samples = 1'000'000;

class CorrectionReader {
 public:
  explicit CorrectionReader(const std::filesystem::path& name) : name_(name) {}

  ShapeCorrection read(const Json& json) const {
    if (!json.is_object()) fail("an object");
    ShapeCorrection correction;
    if (json.contains("yaw")) correction.yaw_quarters = static_cast<int>(count(json["yaw"], 4, "a yaw"));
    if (json.contains("template")) correction.part_template = text(json["template"]);
    if (json.contains("mark")) correction.mark = mark(text(json["mark"]));
    if (json.contains("pinned")) correction.pinned = pinned(json["pinned"]);
    if (json.contains("sampling")) correction.sampling = hash(text(json["sampling"]));
    return correction;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError(name_, "", "expected " + expected);
  }
  std::size_t count(const Json& json, std::size_t below, const char* what) const {
    if (!json.is_number_unsigned() || json.get<std::size_t>() >= below) fail(what);
    return json.get<std::size_t>();
  }
  std::string text(const Json& json) const {
    if (!json.is_string()) fail("a text");
    return json.get<std::string>();
  }
  ShapeMark mark(const std::string& named) const {
    const auto found = std::ranges::find_if(marks, [&](ShapeMark each) { return to_string(each) == named; });
    if (found == marks.end()) fail("none, outlier or learn");
    return *found;
  }
  PinnedParts pinned(const Json& json) const {
    if (!json.is_object()) fail("the pinned samples of parts");
    PinnedParts parts;
    std::vector<std::uint32_t> all;
    for (const auto& [part, samples] : json.items()) {
      if (!samples.is_array() || samples.empty() || samples.size() > most_pinned_samples - all.size())
        fail("a list of samples");
      std::vector<std::uint32_t>& of_part = parts[part];
      for (const Json& sample : samples)
        of_part.push_back(static_cast<std::uint32_t>(count(sample, most_pinned_samples, "a sample")));
      if (!std::ranges::is_sorted(of_part, std::less_equal<>{})) fail("samples in ascending order");
      all.insert(all.end(), of_part.begin(), of_part.end());
    }
    std::ranges::sort(all);
    if (std::ranges::adjacent_find(all) != all.end()) fail("each sample once");
    return parts;
  }
  ContentHash hash(const std::string& hex) const {
    constexpr std::size_t digits = 16;
    ContentHash result;
    const auto word_of = [&](std::size_t at, std::uint64_t& word) {
      const char* begin = hex.data() + at;
      const auto [end, error] = std::from_chars(begin, begin + digits, word, 16);
      return error == std::errc() && end == begin + digits;
    };
    if (hex.size() != 2 * digits || !word_of(0, result.words[0]) || !word_of(digits, result.words[1]) ||
        result.to_hex() != hex)
      fail("32 hexadecimal digits");
    return result;
  }

  const std::filesystem::path& name_;
};

}  // namespace

std::string_view to_string(ShapeMark mark) {
  switch (mark) {
    case ShapeMark::outlier:
      return "outlier";
    case ShapeMark::learn:
      return "learn";
    case ShapeMark::none:
      break;
  }
  return "none";
}

std::string format_correction(const ShapeCorrection& correction) {
  Json json = Json::object();
  if (correction.yaw_quarters) json["yaw"] = *correction.yaw_quarters;
  if (!correction.part_template.empty()) json["template"] = correction.part_template;
  if (correction.mark != ShapeMark::none) json["mark"] = to_string(correction.mark);
  if (!correction.pinned.empty()) json["pinned"] = correction.pinned;
  if (correction.sampling != ContentHash{}) json["sampling"] = correction.sampling.to_hex();
  return json.dump();
}

ShapeCorrection parse_correction(std::string_view text, const std::filesystem::path& name) {
  constexpr int depth = 4;
  return CorrectionReader(name).read(parse_json(text, name, depth));
}

}  // namespace archetype
