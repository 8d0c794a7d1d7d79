// Every setting is described once, in a table that reading, writing and `--set` share.
#include "core/session/settings.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <span>
#include <variant>

#include "core/base/error.h"
#include "core/io/file.h"

namespace archetype {
namespace {

using Json = nlohmann::json;

struct Choice {
  std::string Settings::*member;
  std::vector<std::string> values;  // empty: any text
};
struct Number {
  double Settings::*member;
  double low, high;
  bool or_zero = false;  // 0 leaves it to the program
};
struct Count {
  int Settings::*member;
  int low, high;
};
struct Switch {
  bool Settings::*member;
};

struct Field {
  const char* name;
  std::variant<Choice, Number, Count, Switch> kind;
};

std::vector<Field> fields() {
  return {
      {"theme", Choice{&Settings::theme, {"dark", "light"}}},
      {"navigation", Choice{&Settings::navigation, {"archetype", "blender", "maya"}}},
      {"ui_scale", Number{&Settings::ui_scale, 0.5, 4, true}},
      {"threads", Count{&Settings::threads, 0, 1024}},
      {"window_width", Count{&Settings::window_width, 320, 32768}},
      {"window_height", Count{&Settings::window_height, 240, 32768}},
      {"left_width", Number{&Settings::left_width, 120, 2000}},
      {"right_width", Number{&Settings::right_width, 120, 2000}},
      {"bottom_height", Number{&Settings::bottom_height, 60, 2000}},
      {"show_bottom", Switch{&Settings::show_bottom}},
      {"cell_size", Number{&Settings::cell_size, 48, 256}},
      {"map_tool", Choice{&Settings::map_tool, {"rectangle", "lasso"}}},
      {"map_pictures", Switch{&Settings::map_pictures}},
      {"map_sliders", Switch{&Settings::map_sliders}},
      {"plot", Choice{&Settings::plot, {}}},
      {"inspect_colour",
       Choice{&Settings::inspect_colour, {"part", "plain", "distance", "features", "smoothness"}}},
      {"inspect_fitted_boxes", Switch{&Settings::inspect_fitted_boxes}},
      {"inspect_mean_boxes", Switch{&Settings::inspect_mean_boxes}},
      {"inspect_template_points", Switch{&Settings::inspect_template_points}},
      {"inspect_correspondences", Switch{&Settings::inspect_correspondences}},
      {"inspect_samples", Switch{&Settings::inspect_samples}},
      {"last_folder", Choice{&Settings::last_folder, {}}},
  };
}

std::string range(double low, double high) {
  return Json(low).dump() + " to " + Json(high).dump();
}

// What is wrong with the value, or "".
std::string assign(Settings& settings, const Field& field, const Json& value) {
  const std::string name = field.name;
  if (const auto* choice = std::get_if<Choice>(&field.kind)) {
    if (!value.is_string()) return name + " has to be a text";
    const std::string text = value.get<std::string>();
    if (!choice->values.empty() &&
        std::find(choice->values.begin(), choice->values.end(), text) == choice->values.end()) {
      std::string expected;
      for (const std::string& known : choice->values) expected += (expected.empty() ? "" : ", ") + known;
      return name + " has to be one of " + expected;
    }
    settings.*(choice->member) = text;
  } else if (const auto* number = std::get_if<Number>(&field.kind)) {
    const bool automatic = number->or_zero && value == 0;
    if (!automatic && (!value.is_number() || !(value >= number->low && value <= number->high)))
      return name + " has to be " + (number->or_zero ? "0 or " : "") + "a number from " +
             range(number->low, number->high);
    settings.*(number->member) = value.get<double>();
  } else if (const auto* count = std::get_if<Count>(&field.kind)) {
    if (!value.is_number_integer() || value < count->low || value > count->high)
      return name + " has to be a whole number from " + range(count->low, count->high);
    settings.*(count->member) = value.get<int>();
  } else {
    if (!value.is_boolean()) return name + " has to be true or false";
    settings.*(std::get<Switch>(field.kind).member) = value.get<bool>();
  }
  return "";
}

Json value_of(const Settings& settings, const Field& field) {
  return std::visit([&](const auto& kind) { return Json(settings.*(kind.member)); }, field.kind);
}

}  // namespace

LoadedSettings load_settings(const std::filesystem::path& path) {
  LoadedSettings loaded;
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return loaded;
  constexpr std::uint64_t most_bytes = 1 << 20;
  try {
    const Json json = Json::parse(read_file(path, most_bytes));
    if (!json.is_object()) throw InputError(path, "", "expected an object of settings");
    std::string wrong;
    for (const Field& field : fields()) {
      if (!json.contains(field.name)) continue;
      const std::string problem = assign(loaded.settings, field, json[field.name]);
      if (wrong.empty()) wrong = problem;
    }
    const Json recent = json.value("recent", Json::array());
    const Json keys = json.value("keys", Json::object());
    if (!recent.is_array()) throw InputError(path, "", "recent has to be a list");
    if (!keys.is_object()) throw InputError(path, "", "keys has to be an object");
    for (const Json& entry : recent)
      if (entry.is_string()) loaded.settings.recent.push_back(entry.get<std::string>());
    for (const auto& [command, key] : keys.items())
      if (key.is_string()) loaded.settings.keys[command] = key.get<std::string>();
    if (!wrong.empty()) loaded.problem = path.string() + ": " + wrong + "; the default is used";
  } catch (const std::exception& error) {
    loaded.settings = {};
    loaded.problem =
        path.string() + ": the settings cannot be read and start from the defaults (" + error.what() + ")";
  }
  return loaded;
}

void save_settings(const std::filesystem::path& path, const Settings& settings) {
  Json json;
  for (const Field& field : fields()) json[field.name] = value_of(settings, field);
  json["recent"] = settings.recent;
  json["keys"] = settings.keys;
  std::error_code failed;  // replace_file names the reason if the folder is not there
  std::filesystem::create_directories(path.parent_path(), failed);
  replace_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string set_setting(Settings& settings, std::string_view name, std::string_view value) {
  for (const Field& field : fields()) {
    if (field.name != name) continue;
    Json json = std::string(value);
    if (!std::holds_alternative<Choice>(field.kind)) json = Json::parse(value, nullptr, false);
    return assign(settings, field, json);
  }
  std::string known;
  for (const std::string& each : setting_names()) known += (known.empty() ? "" : ", ") + each;
  return "there is no setting \"" + std::string(name) + "\"; there are " + known;
}

void copy_setting(Settings& to, const Settings& from, std::string_view name) {
  for (const Field& field : fields())
    if (field.name == name) assign(to, field, value_of(from, field));
}

std::vector<std::string> setting_names() {
  std::vector<std::string> names;
  for (const Field& field : fields()) names.emplace_back(field.name);
  return names;
}

void remember_recent(Settings& settings, const std::filesystem::path& path) {
  constexpr std::size_t kept = 12;
  std::erase(settings.recent, path.string());
  settings.recent.insert(settings.recent.begin(), path.string());
  if (settings.recent.size() > kept) settings.recent.resize(kept);
}

}  // namespace archetype
