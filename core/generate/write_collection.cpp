// A generated collection as a folder of files.
#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/generate/find_family.h"

namespace archetype {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void append(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 9);
  text.append(digits.data(), end.ptr);
}

void append(std::string& text, std::size_t value) {
  text += std::to_string(value);
}

void append_point(std::string& text, double x, double y, double z) {
  append(text, x);
  text += ' ';
  append(text, y);
  text += ' ';
  append(text, z);
  text += '\n';
}

std::string format_off(const PolygonMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.face_count()) + " 0\n";
  for (const Vec3& p : mesh.vertices) append_point(text, p.x(), p.y(), p.z());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    append(text, mesh.face(f).size());
    for (const std::uint32_t corner : mesh.face(f)) {
      text += ' ';
      append(text, std::size_t{corner});
    }
    text += '\n';
  }
  return text;
}

// One group per run of faces of one part, as modelling programs write them.
std::string format_obj(const GeneratedShape& shape, const Family& family) {
  std::string text;
  for (const Vec3& p : shape.mesh.vertices) {
    text += "v ";
    append_point(text, p.x(), p.y(), p.z());
  }
  int group = -1;
  for (std::size_t f = 0; f < shape.mesh.face_count(); ++f) {
    if (shape.labels[f] != group) {
      group = shape.labels[f];
      text += "g " + std::string(family.labels[group].name) + '\n';
    }
    text += 'f';
    for (const std::uint32_t corner : shape.mesh.face(f)) {
      text += ' ';
      append(text, std::size_t{corner} + 1);
    }
    text += '\n';
  }
  return text;
}

std::string format_labels(const std::vector<int>& labels) {
  std::string text;
  for (const int label : labels) text += std::to_string(label) + '\n';
  return text;
}

std::string format_landmarks(const std::vector<Landmark>& landmarks) {
  std::string text;
  for (const Landmark& landmark : landmarks) {
    if (landmark.present) {
      append_point(text, landmark.position[0], landmark.position[1], landmark.position[2]);
    } else {
      text += "-1\n";
    }
  }
  return text;
}

std::string format_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += std::to_string(i) + ' ' + names[i] + '\n';
  return text;
}

// Every parameter of any style once, in the order of its first appearance.
std::vector<std::string_view> parameter_columns(const Family& family) {
  std::vector<std::string_view> columns;
  for (const FamilyStyle& style : family.styles) {
    for (const Parameter& parameter : style.parameters) {
      if (std::find(columns.begin(), columns.end(), parameter.name) == columns.end())
        columns.push_back(parameter.name);
    }
  }
  return columns;
}

std::string csv_header(const std::vector<std::string_view>& columns) {
  std::string text = "shape,style,yaw,up,scale";
  for (const std::string_view column : columns) text += ',' + std::string(column);
  return text + '\n';
}

std::string csv_row(const GeneratedShape& shape, const std::vector<std::string_view>& columns) {
  std::string text = shape.name + ',' + shape.style + ',';
  append(text, shape.yaw_degrees);
  text += ',' + std::string(to_string(shape.up)) + ',';
  append(text, shape.scale);
  for (const std::string_view column : columns) {
    text += ',';
    for (const auto& [name, value] : shape.parameters) {
      if (name == column) append(text, value);
    }
  }
  return text + '\n';
}

Json describe(const Distribution& distribution) {
  switch (distribution.kind) {
    case Distribution::Kind::uniform:
      return {{"distribution", "uniform"}, {"low", distribution.a}, {"high", distribution.b}};
    case Distribution::Kind::normal:
      return {{"distribution", "normal"},
              {"mean", distribution.a},
              {"stddev", distribution.b},
              {"cut_at_stddevs", 2.5}};
    case Distribution::Kind::chance:
      return {{"distribution", "chance"}, {"probability", distribution.a}};
    case Distribution::Kind::whole:
      return {{"distribution", "whole"}, {"low", distribution.a}, {"high", distribution.b}};
  }
  throw PreconditionError("a distribution of an unknown kind is to be described");
}

std::string describe(const Family& family, const GenerateOptions& options) {
  Json styles = Json::array();
  for (const FamilyStyle& style : family.styles) {
    const bool drawn = options.styles.empty() || std::find(options.styles.begin(), options.styles.end(),
                                                           style.name) != options.styles.end();
    if (!drawn) continue;
    Json parameters = Json::array();
    for (const Parameter& parameter : style.parameters) {
      Json entry = {{"name", parameter.name}, {"meaning", parameter.meaning}};
      entry.update(describe(parameter.distribution));
      parameters.push_back(std::move(entry));
    }
    styles.push_back({{"name", style.name}, {"weight", style.weight}, {"parameters", std::move(parameters)}});
  }
  const FamilyNames names = family_names(std::string(family.name));
  Json ups = Json::array();
  for (const UpAxis up : options.ups) ups.push_back(to_string(up));
  const char* const yaw = options.yaw == YawChoice::none       ? "none"
                          : options.yaw == YawChoice::quarters ? "quarters"
                                                               : "any";
  const Json document = {{"format", "archetype-generated"},
                         {"version", 1},
                         {"family", family.name},
                         {"count", options.count},
                         {"seed", options.seed},
                         {"file_ending", options.ending == ShapeEnding::off ? "off" : "obj"},
                         {"labels", names.labels},
                         {"landmarks", names.landmarks},
                         {"options",
                          {{"noise", options.noise},
                           {"missing_parts", options.missing_parts},
                           {"flipped", options.faults.flipped},
                           {"duplicate", options.faults.duplicate},
                           {"intersecting", options.faults.intersecting},
                           {"non_manifold", options.faults.non_manifold},
                           {"degenerate", options.faults.degenerate},
                           {"yaw", yaw},
                           {"scale_spread", options.scale_spread},
                           {"offset", options.offset},
                           {"up", std::move(ups)},
                           {"triangles", options.triangles}}},
                         {"styles", std::move(styles)}};
  return document.dump(1) + '\n';
}

// In one step, so that a file that is there is whole. Unlike replace_file() without waiting for the disk,
// three times a shape: what a power cut takes is generated again.
void write_file(const fs::path& path, const std::string& text) {
  const fs::path part = path.string() + ".part";
  std::ofstream file(part, std::ios::binary);
  if (!file) throw FileError(path, "cannot be created; the folder has to be writable");
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::error_code failure;
  if (file) fs::rename(part, path, failure);
  if (file && !failure) return;
  fs::remove(part, failure);
  throw FileError(path, "could not be written in full; is the disk full?");
}

// Makes the folder ready, or finds it ready for the same collection.
void prepare_folder(const fs::path& folder, const std::string& description) {
  std::error_code failure;
  if (fs::exists(folder, failure) && !fs::is_empty(folder, failure) && !failure) {
    std::ifstream file(folder / "generator.json", std::ios::binary);
    const std::string there((std::istreambuf_iterator<char>(file)), {});
    if (there != description) {
      throw FileError(folder,
                      "is not empty and holds no collection of this family and these options; "
                      "name a new folder, or remove this one");
    }
  }
  for (const char* sub : {"shapes", "labels", "landmarks"}) {
    fs::create_directories(folder / sub, failure);
    if (failure) throw FileError(folder / sub, "cannot be created: " + failure.message());
  }
  write_file(folder / "generator.json", description);
}

}  // namespace

std::string describe_collection(const std::string& family, const GenerateOptions& options) {
  return describe(find_family(family), options);
}

GenerateReport write_collection(const std::string& family_name, const GenerateOptions& options,
                                const fs::path& folder, const JobControl& control) {
  const Family family = find_family(family_name);
  const FamilyNames names = family_names(family_name);
  const std::vector<std::string_view> columns = parameter_columns(family);
  generate_shape(family, options, 0);  // refuses bad options before anything is written
  prepare_folder(folder, describe(family, options));
  write_file(folder / "labels" / "names.txt", format_names(names.labels));
  write_file(folder / "landmarks" / "names.txt", format_names(names.landmarks));

  std::vector<std::string> rows(options.count);
  const bool finished =
      parallel_for(options.count, options.threads, control, "generating", [&](std::size_t i) {
        const GeneratedShape shape = generate_shape(family, options, i);
        const bool obj = options.ending == ShapeEnding::obj;
        const fs::path mesh = folder / "shapes" / (shape.name + (obj ? ".obj" : ".off"));
        const fs::path labels = folder / "labels" / (shape.name + ".seg");
        const fs::path landmarks = folder / "landmarks" / (shape.name + ".vts");
        if (!fs::exists(mesh)) write_file(mesh, obj ? format_obj(shape, family) : format_off(shape.mesh));
        if (!fs::exists(labels)) write_file(labels, format_labels(shape.labels));
        if (!fs::exists(landmarks)) write_file(landmarks, format_landmarks(shape.landmarks));
        rows[i] = csv_row(shape, columns);
      });

  GenerateReport report;
  report.cancelled = !finished;
  for (const std::string& row : rows) report.written += row.empty() ? 0 : 1;
  if (finished) {
    std::string table = csv_header(columns);
    for (const std::string& row : rows) table += row;
    write_file(folder / "styles.csv", table);
  }
  return report;
}

}  // namespace archetype
