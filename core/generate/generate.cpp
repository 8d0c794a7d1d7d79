// From drawn parameters to a shape as a file would hold it: missing parts, noise, faults, place and size.
#include "core/generate/generate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/random.h"
#include "core/generate/find_family.h"
#include "core/geometry/surface_search.h"

namespace archetype {

namespace {

// What a shape's random streams are for; the values are part of what a seed means.
enum Purpose : std::uint64_t {
  style_stream = 1,
  parameter_stream,
  missing_stream,
  noise_stream,
  fault_stream,
  place_stream
};

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void check(const GenerateOptions& options) {
  const auto share = [](double value, const char* name) {
    if (!(value >= 0 && value <= 1)) throw PreconditionError(std::string(name) + " has to lie in 0 to 1");
  };
  share(options.noise, "noise");
  share(options.missing_parts, "missing parts");
  share(options.faults.flipped, "flipped faces");
  share(options.faults.duplicate, "duplicate faces");
  share(options.faults.intersecting, "intersecting faces");
  share(options.faults.non_manifold, "non-manifold faces");
  share(options.faults.degenerate, "degenerate faces");
  if (!(options.scale_spread >= 0 && options.scale_spread <= 20)) {
    throw PreconditionError("the spread of scales has to lie in 0 to 20");
  }
  if (!(options.offset >= 0 && options.offset <= 1e6)) {
    throw PreconditionError("the offset has to lie in 0 to 1,000,000");
  }
  if (options.ups.empty()) throw PreconditionError("at least one up axis has to be given");
}

const FamilyStyle& draw_style(const Family& family, const std::vector<std::string>& wanted,
                              std::uint64_t seed) {
  for (const std::string& name : wanted) {
    if (std::none_of(family.styles.begin(), family.styles.end(),
                     [&](const auto& style) { return style.name == name; })) {
      throw PreconditionError("there is no style \"" + name + "\" of " + std::string(family.name) +
                              "; it has " + join(family_names(std::string(family.name)).styles));
    }
  }
  std::vector<const FamilyStyle*> allowed;
  double sum = 0;
  for (const FamilyStyle& style : family.styles) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), style.name) == wanted.end()) continue;
    allowed.push_back(&style);
    sum += style.weight;
  }
  double left = RandomStream(seed).uniform() * sum;
  for (const FamilyStyle* style : allowed) {
    left -= style->weight;
    if (left < 0) return *style;
  }
  return *allowed.back();
}

// Takes away the faces and landmarks of labels that a coin flip (one per label, present or not) names.
void drop_parts(Assembly& assembly, const Family& family, double probability, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<bool> missing;
  for (const FamilyLabel& label : family.labels)
    missing.push_back(random.uniform() < probability && label.may_miss);

  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(assembly.mesh.vertices.size(), unused);
  Assembly kept;
  for (std::size_t f = 0; f < assembly.mesh.face_count(); ++f) {
    if (missing[assembly.labels[f]]) continue;
    std::vector<std::uint32_t> corners(assembly.mesh.face(f).begin(), assembly.mesh.face(f).end());
    for (std::uint32_t& corner : corners) {
      if (new_index[corner] == unused) {
        new_index[corner] = static_cast<std::uint32_t>(kept.mesh.vertices.size());
        kept.mesh.vertices.push_back(assembly.mesh.vertices[corner]);
      }
      corner = new_index[corner];
    }
    kept.mesh.add_face(corners);
    kept.labels.push_back(assembly.labels[f]);
  }
  for (const PlacedLandmark& landmark : assembly.landmarks) {
    if (!missing[landmark.label]) kept.landmarks.push_back(landmark);
  }
  assembly = std::move(kept);
}

void cut_into_triangles(Assembly& assembly) {
  const Triangulation triangulation = triangulate(assembly.mesh);
  PolygonMesh cut;
  cut.vertices = std::move(assembly.mesh.vertices);
  std::vector<int> labels;
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    cut.add_face(triangulation.triangles[t]);
    labels.push_back(assembly.labels[triangulation.faces[t]]);
  }
  assembly.mesh = std::move(cut);
  assembly.labels = std::move(labels);
}

// Families mark places to a few millimetres; the ground truth has them exactly on the surface of their part.
void snap_to_surface(Assembly& assembly) {
  const Triangulation triangulation = triangulate(assembly.mesh);
  for (PlacedLandmark& landmark : assembly.landmarks) {
    double best = std::numeric_limits<double>::infinity();
    Vec3 closest = landmark.position;
    for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
      if (assembly.labels[triangulation.faces[t]] != landmark.label) continue;
      const auto& [i, j, k] = triangulation.triangles[t];
      const auto& vertices = assembly.mesh.vertices;
      const SurfacePoint near =
          closest_on_triangle({vertices[i], vertices[j], vertices[k]}, landmark.position);
      if (near.squared_distance >= best) continue;
      best = near.squared_distance;
      closest = near.weights[0] * vertices[i] + near.weights[1] * vertices[j] + near.weights[2] * vertices[k];
    }
    landmark.position = closest;
  }
}

std::string shape_name(const Family& family, std::size_t index) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "_%05zu", index);
  return std::string(family.shape) + number.data();
}

double diagonal(const PolygonMesh& mesh) {
  return 2 * bounds(mesh).half_extent().norm();
}

// Turns, scales, moves the shape and lays it down; the draws are the same whatever the options.
void put_in_place(GeneratedShape& shape, const GenerateOptions& options, std::uint64_t seed) {
  RandomStream random(seed);
  const double turn = random.uniform();
  const auto quarter = static_cast<double>(static_cast<int>(4 * turn));
  if (options.yaw == YawChoice::quarters) shape.yaw_degrees = 90 * quarter;
  if (options.yaw == YawChoice::any) shape.yaw_degrees = 360 * turn;
  shape.scale = std::exp(options.scale_spread * random.uniform(-1, 1));
  shape.up = options.ups[random.below(options.ups.size())];
  const double reach = options.offset * shape.scale * diagonal(shape.mesh);
  const double x = random.uniform(-1, 1);
  const double y = random.uniform(-1, 1);
  const double z = random.uniform(-1, 1);
  const Vec3 offset = reach * Vec3(x, y, z);

  const double angle = shape.yaw_degrees * std::numbers::pi / 180;
  const Mat3 turned = shape.scale * upright_rotation(shape.up).transpose() *
                      Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
  for (Vec3& p : shape.mesh.vertices) p = turned * p + offset;
  for (Landmark& landmark : shape.landmarks) {
    if (!landmark.present) continue;
    const Vec3 p = turned * Vec3(landmark.position[0], landmark.position[1], landmark.position[2]) + offset;
    landmark.position = {p.x(), p.y(), p.z()};
  }
}

}  // namespace

std::vector<Family> all_families() {
  return {chairs(), lamps(), planes(), tables()};
}

std::vector<std::string> families() {
  std::vector<std::string> names;
  for (const Family& family : all_families()) names.emplace_back(family.name);
  return names;
}

Family find_family(const std::string& name) {
  for (Family& family : all_families()) {
    if (family.name == name) return std::move(family);
  }
  throw PreconditionError("there is no family \"" + name + "\"; there are " + join(families()));
}

FamilyNames family_names(const std::string& name) {
  const Family family = find_family(name);
  FamilyNames names{name, {}, {}, {}};
  for (const FamilyLabel& label : family.labels) names.labels.emplace_back(label.name);
  names.landmarks.assign(family.landmarks.begin(), family.landmarks.end());
  for (const FamilyStyle& style : family.styles) names.styles.emplace_back(style.name);
  return names;
}

GeneratedShape generate_shape(const Family& family, const GenerateOptions& options, std::size_t index) {
  check(options);
  const ContentHash family_key = hash_content(std::as_bytes(std::span(family.name)));
  const std::uint64_t seed = derive_seed(derive_seed(options.seed, family_key.words[0]), index);
  const FamilyStyle& style = draw_style(family, options.styles, derive_seed(seed, style_stream));
  const ParameterValues parameters = draw_parameters(style.parameters, derive_seed(seed, parameter_stream));
  Assembly assembly = style.build(parameters);
  drop_parts(assembly, family, options.missing_parts, derive_seed(seed, missing_stream));
  if (options.triangles) cut_into_triangles(assembly);
  if (options.noise > 0) {
    RandomStream random(derive_seed(seed, noise_stream));
    const double deviation = options.noise * diagonal(assembly.mesh);
    for (Vec3& p : assembly.mesh.vertices) {
      for (int axis = 0; axis < 3; ++axis) p[axis] += deviation * random.normal();
    }
  }
  snap_to_surface(assembly);
  if (options.faults.any()) {
    add_faults(assembly.mesh, assembly.labels, options.faults, derive_seed(seed, fault_stream));
  }

  GeneratedShape shape;
  shape.name = shape_name(family, index);
  shape.style = style.name;
  shape.mesh = std::move(assembly.mesh);
  shape.labels = std::move(assembly.labels);
  shape.landmarks.resize(family.landmarks.size());
  for (const PlacedLandmark& landmark : assembly.landmarks) {
    const Vec3& p = landmark.position;
    shape.landmarks[landmark.index] = {true, {p.x(), p.y(), p.z()}};
  }
  shape.parameters.assign(parameters.values.begin(), parameters.values.end());
  put_in_place(shape, options, derive_seed(seed, place_stream));
  return shape;
}

GeneratedShape generate_shape(const std::string& family, const GenerateOptions& options, std::size_t index) {
  return generate_shape(find_family(family), options, index);
}

}  // namespace archetype
