// Formats tables and point clouds of an export. Numbers are the shortest text that reads back as the same
// double, so that the same project gives the same bytes.
#include "core/io/export_files.h"

#include <bit>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/model/part_colours.h"

namespace archetype {

namespace {

constexpr std::size_t longest_name = 200;  // bytes; file systems take 255, endings included

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

void append(std::string& row, double value) {
  row += ',' + number_text(value);
}

void append(std::string& row, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) append(row, v[axis]);
}

template <class Integer>
void put(std::string& out, Integer value) {
  const auto bits = static_cast<std::uint64_t>(value);
  for (std::size_t i = 0; i < sizeof(Integer); ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
}

void put(std::string& out, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) put(out, std::bit_cast<std::uint64_t>(v[axis]));
}

bool may_stand_in_name(unsigned char c) {
  return c >= 0x20 && c != 0x7f && c != '/';
}

// A cut that does not go through a character of UTF-8.
std::string shortened(const std::string& text) {
  std::size_t end = longest_name;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end);
}

}  // namespace

std::string export_file_name(const std::string& name) {
  std::string safe = name;
  for (char& c : safe) {
    if (!may_stand_in_name(static_cast<unsigned char>(c))) c = '_';
  }
  if (safe.empty()) safe.push_back('_');
  if (safe.size() > longest_name) safe = shortened(safe);
  if (safe == name) return name;
  return safe + '-' + hash_content(std::as_bytes(std::span(name))).to_hex().substr(0, 12);
}

std::string unique_export_name(const std::string& name, std::set<std::string>& taken) {
  const std::string base = export_file_name(name);
  std::string unique = base;
  for (int n = 2; !taken.insert(unique).second; ++n) unique = base + '-' + std::to_string(n);
  return unique;
}

std::string fits_header() {
  return "shape,template,yaw_degrees,energy,e_data,e_deform,e_smooth,e_feature,status,e_exist\n";
}

namespace {

// About +y: by how much the samples were turned to stand straight (geometry/straighten.h).
double straightened_degrees(const ShapeRecord& shape) {
  const Mat3 turn = shape.frame.rotation * upright_rotation(shape.up).transpose();
  return std::atan2(turn(0, 2), turn(0, 0)) * 180 / std::numbers::pi;
}

}  // namespace

std::string fits_row(const std::string& name, const ShapeRecord& shape, const std::string& part_template,
                     const FitRecord& fit) {
  const FitEnergy& energy = fit.fit.energy;
  std::string row = field(name) + ',' + field(part_template);
  append(row, std::fmod(90 * fit.fit.yaw_quarters - straightened_degrees(shape) + 360, 360));
  for (const double term :
       {energy.total(), energy.data(), energy.deformation, energy.smoothness, energy.features}) {
    append(row, term);
  }
  row += ',' + std::string(to_string(fit.status));
  append(row, energy.existence);
  return row + '\n';
}

std::string parts_header() {
  return "template,part,name,label,must_exist,existence\n";
}

std::string parts_rows(const std::string& template_name, const PartTemplate& part_template) {
  std::string rows;
  for (std::size_t i = 0; i < part_template.parts.size(); ++i) {
    const TemplatePart& part = part_template.parts[i];
    rows += field(template_name) + ',' + std::to_string(i) + ',' + field(part.name) + ',' +
            std::to_string(part.label) + (part.must_exist ? ",1," : ",0,") + number_text(part.existence) +
            '\n';
  }
  return rows;
}

namespace {

std::string name_of(Solid solid) {
  switch (solid) {
    case Solid::box:
      break;
    case Solid::cylinder_x:
      return "cylinder_x";
    case Solid::cylinder_y:
      return "cylinder_y";
    case Solid::cylinder_z:
      return "cylinder_z";
    case Solid::ellipsoid:
      return "ellipsoid";
  }
  return "box";
}

}  // namespace

std::string boxes_header() {
  return "shape,part,present,centre_x,centre_y,centre_z,half_x,half_y,half_z,"
         "orientation_w,orientation_x,orientation_y,orientation_z,solid\n";
}

std::string boxes_rows(const std::string& shape, const ShapeFrame& frame, const ShapeFit& fit) {
  Mat3 turn;  // from the template's frame to the file's
  for (int axis = 0; axis < 3; ++axis) {
    turn.col(axis) =
        frame.rotation.transpose() * (fit.to_shape(Vec3::Unit(axis)) - fit.to_shape(Vec3::Zero()));
  }
  std::string rows;
  for (std::size_t i = 0; i < fit.parts.size(); ++i) {
    const FittedPart& part = fit.parts[i];
    const Eigen::Quaterniond orientation = Eigen::Quaterniond(turn) * part.box.orientation;
    rows += field(shape) + ',' + std::to_string(i) + (part.present ? ",1" : ",0");
    append(rows, frame.to_file(fit.to_shape(part.box.centre)));
    append(rows, Vec3(part.box.half_extent / frame.scale));
    for (const double q : {orientation.w(), orientation.x(), orientation.y(), orientation.z()})
      append(rows, q);
    rows += ',' + name_of(part.box.solid) + '\n';
  }
  return rows;
}

std::string coaligned_ply(const PartTemplate& part_template, const ShapeSamples& samples,
                          std::span<const Vec3> canonical, const ShapeFit& fit) {
  std::string ply = "ply\nformat binary_little_endian 1.0\ncomment written by Archetype\nelement vertex " +
                    std::to_string(samples.size()) + '\n';
  for (const char* name : {"x", "y", "z", "cx", "cy", "cz"})
    ply += std::string("property double ") + name + '\n';
  ply += "property int part\nproperty uint face\n";
  for (const char* name : {"red", "green", "blue"}) ply += std::string("property uchar ") + name + '\n';
  ply += "end_header\n";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    put(ply, samples.frame.to_file(samples.points[i]));
    put(ply, canonical[i]);
    put(ply, std::int32_t{fit.labels[i]});
    put(ply, samples.faces[i]);
    for (const std::uint8_t channel : part_colour(part_template, fit.labels[i])) put(ply, channel);
  }
  return ply;
}

}  // namespace archetype
