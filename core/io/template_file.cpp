// Template files: checked key by key, so that whatever comes out of here can be fitted.
#include "core/io/template_file.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/file.h"
#include "core/io/json_input.h"
#include "core/model/part_colours.h"

namespace archetype {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;  // for writing, so that people find the keys in a sensible order

constexpr std::string_view format_name = "archetype-template";
constexpr int format_version = 1;
constexpr std::size_t most_unknown_keys = 256;
constexpr std::uint64_t most_bytes = 16 << 20;
// Quaternions this close to a unit one are kept to the bit, so that files round trip.
constexpr double unit_tolerance = 1e-12;

// A value of the file, and where it stands: "parts[2].scale.mean".
class Node {
 public:
  Node(const Json& json, std::string key_path, const std::filesystem::path& file)
      : json_(&json), path_(std::move(key_path)), file_(&file) {}

  const Json& json() const { return *json_; }
  [[noreturn]] void fail(const std::string& problem) const { throw InputError(*file_, path_, problem); }

  void expect_object() const {
    if (!json_->is_object()) fail(std::string("expected an object, found ") + json_->type_name());
  }
  bool has(const char* key) const { return json_->contains(key); }
  Node at(const char* key) const {
    const auto found = json_->find(key);
    const std::string child_path = path_.empty() ? key : path_ + "." + key;
    if (found == json_->end()) throw InputError(*file_, child_path, "the key is missing");
    return {*found, child_path, *file_};
  }
  Node at(std::size_t index) const {
    return {(*json_)[index], path_ + "[" + std::to_string(index) + "]", *file_};
  }
  void expect_array(std::size_t least, std::size_t most) const {
    if (json_->is_array() && json_->size() >= least && json_->size() <= most) return;
    const std::string size = least == most ? std::to_string(most) : "at most " + std::to_string(most);
    fail("expected an array of " + size + " values, found " +
         (json_->is_array() ? std::to_string(json_->size()) + " values" : std::string(json_->type_name())));
  }

  std::string text() const {
    if (!json_->is_string()) fail(std::string("expected a text, found ") + json_->type_name());
    return json_->get<std::string>();
  }
  bool boolean() const {
    if (!json_->is_boolean()) fail(std::string("expected true or false, found ") + json_->type_name());
    return json_->get<bool>();
  }
  double number(double low, double high) const {
    if (!json_->is_number()) fail(std::string("expected a number, found ") + json_->type_name());
    const auto value = json_->get<double>();
    if (!(value >= low && value <= high)) {
      fail("expected a number from " + Json(low).dump() + " to " + Json(high).dump() + ", found " +
           json_->dump());
    }
    return value;
  }
  int integer(int low, int high) const {
    if (!json_->is_number_integer()) fail(std::string("expected a whole number, found ") + json_->dump());
    return static_cast<int>(number(low, high));
  }
  // Fills anything indexable with numbers of one range.
  template <typename Values>
  void numbers(std::size_t count, Values& values, double low, double high) const {
    expect_array(count, count);
    for (std::size_t i = 0; i < count; ++i) values[i] = at(i).number(low, high);
  }

 private:
  const Json* json_;
  std::string path_;
  const std::filesystem::path* file_;
};

// What is left of an object without the keys that this version knows, as text; empty if nothing is.
std::string unknown_keys(const Node& node, std::initializer_list<std::string_view> known) {
  Json rest = Json::object();
  for (const auto& [key, value] : node.json().items()) {
    if (std::ranges::find(known, key) == known.end()) rest[key] = value;
  }
  if (rest.size() > most_unknown_keys) {
    node.fail("more than " + std::to_string(most_unknown_keys) + " keys that are not known");
  }
  return rest.empty() ? "" : rest.dump();
}

void add_unknown_keys(OrderedJson& object, const std::string& extra_json) {
  if (extra_json.empty()) return;
  const Json extra = Json::parse(extra_json, nullptr, /*allow_exceptions=*/false);
  if (!extra.is_object()) throw PreconditionError("extra_json of a template or part is no JSON object");
  for (const auto& [key, value] : extra.items()) {
    if (!object.contains(key)) object[key] = value;
  }
}

void parse_gaussian(const Node& node, double least_mean, Gaussian3& gaussian) {
  node.expect_object();
  node.at("mean").numbers(3, gaussian.mean, least_mean, largest_template_value);
  if (node.has("stddev"))
    node.at("stddev").numbers(3, gaussian.stddev, least_template_spread, largest_template_value);
}

Eigen::Quaterniond parse_orientation(const Node& node) {
  std::array<double, 4> wxyz{};
  node.numbers(4, wxyz, -largest_template_value, largest_template_value);
  Eigen::Quaterniond quaternion(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const double norm = quaternion.norm();
  if (norm < least_template_spread) node.fail("expected a unit quaternion w x y z, found zero");
  if (std::abs(norm - 1) > unit_tolerance) quaternion.coeffs() /= norm;
  return quaternion;
}

MirrorLink parse_mirror(const Node& node) {
  node.expect_object();
  MirrorLink mirror;
  mirror.pair = node.at("pair").integer(1, std::numeric_limits<int>::max());
  const std::string axis = node.at("axis").text();
  if (axis != "x" && axis != "z") node.at("axis").fail("expected \"x\" or \"z\", found \"" + axis + "\"");
  mirror.axis = axis == "x" ? 0 : 2;
  return mirror;
}

TemplatePart parse_part(const Node& node, int index) {
  node.expect_object();
  TemplatePart part;
  part.name = node.at("name").text();
  part.label = node.has("label") ? node.at("label").integer(0, std::numeric_limits<int>::max()) : index;
  if (node.has("must_exist")) part.must_exist = node.at("must_exist").boolean();
  if (node.has("orientation")) part.orientation = parse_orientation(node.at("orientation"));
  parse_gaussian(node.at("position"), -largest_template_value, part.position);
  parse_gaussian(node.at("scale"), least_template_spread, part.scale);
  if (node.has("features")) {
    const Node features = node.at("features");
    features.expect_object();
    part.has_features = true;
    features.at("mean").numbers(feature_count, part.features.mean, -largest_template_value,
                                largest_template_value);
    if (features.has("stddev")) {
      features.at("stddev").numbers(feature_count, part.features.stddev, least_template_spread,
                                    largest_template_value);
    }
  }
  if (node.has("existence")) part.existence = node.at("existence").number(least_template_spread, 1);
  if (node.has("palette_colour")) part.colour = node.at("palette_colour").integer(0, part_colour_count - 1);
  if (node.has("mirror_link")) part.mirror = parse_mirror(node.at("mirror_link"));
  part.extra_json = unknown_keys(node, {"name", "label", "must_exist", "orientation", "position", "scale",
                                        "features", "existence", "mirror_link", "palette_colour"});
  return part;
}

OrderedJson array_of(const auto& values) {
  OrderedJson array = OrderedJson::array();
  for (const double value : values) array.push_back(value);
  return array;
}

OrderedJson format_part(const TemplatePart& part) {
  const Eigen::Quaterniond& q = part.orientation;
  OrderedJson json;
  json["name"] = part.name;
  json["label"] = part.label;
  json["must_exist"] = part.must_exist;
  json["orientation"] = {q.w(), q.x(), q.y(), q.z()};
  json["position"] = {{"mean", array_of(part.position.mean)}, {"stddev", array_of(part.position.stddev)}};
  json["scale"] = {{"mean", array_of(part.scale.mean)}, {"stddev", array_of(part.scale.stddev)}};
  if (part.has_features) {
    json["features"] = {{"mean", array_of(part.features.mean)}, {"stddev", array_of(part.features.stddev)}};
  }
  json["existence"] = part.existence;
  if (part.mirror.pair > 0)
    json["mirror_link"] = {{"pair", part.mirror.pair}, {"axis", part.mirror.axis == 0 ? "x" : "z"}};
  if (part.colour >= 0) json["palette_colour"] = part.colour;
  add_unknown_keys(json, part.extra_json);
  return json;
}

}  // namespace

PartTemplate parse_template(std::string_view json, const std::filesystem::path& name) {
  const Json document = parse_json(json, name);
  const Node root(document, "", name);
  root.expect_object();
  const Node format = root.at("format");
  if (format.text() != format_name)
    format.fail("expected \"archetype-template\"; this is another kind of file");
  const Node version = root.at("version");
  if (version.integer(1, std::numeric_limits<int>::max()) > format_version) {
    version.fail("the file was written by a newer version of the program; this one reads version 1");
  }
  if (root.has("up") && root.at("up").text() != "y") {
    root.at("up").fail("expected \"y\": templates stand upright along y; turn the boxes and write \"y\"");
  }
  PartTemplate result;
  result.name = root.at("name").text();
  const Node parts = root.at("parts");
  parts.expect_array(0, most_template_parts);
  for (std::size_t i = 0; i < parts.json().size(); ++i) {
    result.parts.push_back(parse_part(parts.at(i), static_cast<int>(i)));
  }
  result.extra_json = unknown_keys(root, {"format", "version", "name", "up", "parts"});
  return result;
}

PartTemplate read_template(const std::filesystem::path& path) {
  return parse_template(read_file(path, most_bytes), path);
}

std::string format_template(const PartTemplate& part_template) {
  OrderedJson json;
  json["format"] = format_name;
  json["version"] = format_version;
  json["name"] = part_template.name;
  json["up"] = "y";
  json["parts"] = OrderedJson::array();
  for (const TemplatePart& part : part_template.parts) json["parts"].push_back(format_part(part));
  add_unknown_keys(json, part_template.extra_json);
  // Names may come from file names, which need not be UTF-8.
  std::string text = json.dump(2, ' ', /*ensure_ascii=*/false, OrderedJson::error_handler_t::replace) + "\n";
  try {
    parse_template(text, "");  // what cannot be read again must not replace a good file
  } catch (const InputError& error) {
    throw PreconditionError(std::string("the template cannot be written") + error.what());
  }
  return text;
}

void write_template(const std::filesystem::path& path, const PartTemplate& part_template) {
  replace_file(path, format_template(part_template));
}

}  // namespace archetype
