#include "ui/strip_shape.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/parallel.h"
#include "core/geometry/decimate.h"
#include "core/geometry/kd_tree.h"
#include "render/convert.h"
#include "render/thumbnails.h"
#include "ui/shape_loader.h"

namespace archetype {
namespace {

// More are not seen in a picture of a hundred pixels, and eight of them are drawn in one frame.
constexpr std::size_t most_tile_triangles = 2500;

// Samples by the face of the file that they lie on.
using SamplesOfFaces = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // face, sample

SamplesOfFaces samples_of_faces(const ShapeSamples& samples) {
  SamplesOfFaces result;
  for (std::uint32_t i = 0; i < samples.faces.size(); ++i) result.emplace_back(samples.faces[i], i);
  std::ranges::sort(result);
  return result;
}

void add_voters(StripShape& shape, const MeshGeometry& mesh, const std::vector<std::uint32_t>& file_faces) {
  const SamplesOfFaces on_faces = samples_of_faces(*shape.samples);
  const KdTree tree(shape.samples->points);
  for (std::size_t t = 0; t < file_faces.size(); ++t) {
    const std::uint32_t face = file_faces[t];
    auto at = std::ranges::lower_bound(on_faces, std::pair(face, std::uint32_t{0}));
    const std::size_t before = shape.voters.size();
    for (; at != on_faces.end() && at->first == face; ++at) shape.voters.push_back(at->second);
    if (shape.voters.size() == before) {
      const glm::vec3 middle =
          (mesh.positions[3 * t] + mesh.positions[3 * t + 1] + mesh.positions[3 * t + 2]) / 3.F;
      shape.voters.push_back(tree.nearest(to_eigen(glm::dvec3(middle))).index);
    }
    shape.voter_begins.push_back(static_cast<std::uint32_t>(shape.voters.size()));
  }
}

// Nothing if cancelled.
bool add_mesh(StripShape& shape, const PolygonMesh& mesh, const JobControl& control) {
  MeshGeometry geometry;
  if (triangulate(mesh).triangles.size() > most_tile_triangles) {
    const auto decimated = decimate(mesh, most_tile_triangles, control);
    if (!decimated) return false;
    geometry = make_mesh_geometry(decimated->mesh, shape.record.frame);
    for (std::uint32_t& face : geometry.faces) face = decimated->faces[face];
  } else {
    geometry = make_mesh_geometry(mesh, shape.record.frame);
  }
  add_voters(shape, geometry, geometry.faces);
  for (std::uint32_t t = 0; t < geometry.faces.size(); ++t) geometry.faces[t] = t;
  geometry.face_count = geometry.faces.size();
  shape.display.mesh = std::make_shared<const MeshGeometry>(std::move(geometry));
  return true;
}

// The label that most have; of several the lowest.
std::int16_t majority(std::vector<std::int16_t>& labels) {
  std::ranges::sort(labels);
  std::int16_t best = labels.front();
  std::ptrdiff_t most = 0;
  for (auto at = labels.begin(); at != labels.end();) {
    const auto next = std::upper_bound(at, labels.end(), *at);
    if (next - at > most) {
      most = next - at;
      best = *at;
    }
    at = next;
  }
  return best;
}

}  // namespace

std::optional<LoadedStripShape> load_strip_shape(const LoadStripShape& request, const JobControl& control) {
  const std::optional<LoadedShape> loaded = load_shape({request.project, request.shape}, control);
  if (control.cancelled()) return std::nullopt;
  StripShape shape;
  shape.id = request.shape;
  if (!loaded || !loaded->shape.samples || loaded->shape.samples->points.empty()) {
    shape.problem = loaded && !loaded->shape.problem.empty() ? loaded->shape.problem
                                                             : "the project has no samples of this shape";
    return std::make_shared<const StripShape>(std::move(shape));
  }
  shape.record = *loaded->shape.record;
  shape.samples = loaded->shape.samples;
  shape.display.shape_revision = 1;
  const std::shared_ptr<const PolygonMesh> mesh = loaded->shape.mesh;
  if (mesh && !mesh->is_point_set()) {
    if (!add_mesh(shape, *mesh, control)) return std::nullopt;
  } else {
    shape.display.samples = std::make_shared<const PointGeometry>(make_point_geometry(*shape.samples));
  }
  return std::make_shared<const StripShape>(std::move(shape));
}

ShapeColours strip_colours(const StripShape& shape, const PartTemplate& part_template, const ShapeFit& fit) {
  ShapeColours colours;
  if (shape.display.samples) colours.samples = colours_of_labels(fit.labels, &part_template);
  if (!shape.display.mesh) return colours;
  std::vector<std::int16_t> labels;
  std::vector<std::int16_t> votes;
  for (std::size_t t = 0; t + 1 < shape.voter_begins.size(); ++t) {
    votes.clear();
    for (std::uint32_t i = shape.voter_begins[t]; i < shape.voter_begins[t + 1]; ++i)
      votes.push_back(fit.labels[shape.voters[i]]);
    labels.push_back(majority(votes));
  }
  colours.elements = colours_of_labels(labels, &part_template);
  return colours;
}

std::optional<StripFitResult> StripFitters::run(const StripFitRequest& request, const JobControl& control) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t count = request.shapes.size();
  StripFitResult result;
  result.document_revision = request.document_revision;
  result.fits.resize(count);
  std::vector<std::string> problems(count);
  const std::shared_ptr<const PartTemplate> expecting = expected_->of(request.part_template);
  std::map<ShapeId, LiveFitter> fitters;  // without those of shapes that are no longer there
  for (const auto& shape : request.shapes) fitters[shape->id] = std::move(fitters_[shape->id]);
  fitters_ = std::move(fitters);
  const bool whole = parallel_for(count, 0, control, "Strip", [&](std::size_t i) {
    LiveFitRequest one;
    one.part_template = expecting;
    one.samples = request.shapes[i]->samples;
    if (request.starts[i])
      one.start = std::shared_ptr<const ViewFit>(request.starts[i], &request.starts[i]->view);
    one.keep_yaw = request.keep_yaw;
    one.dragging = request.dragging;
    one.costs = false;  // a tile does not show them
    const std::optional<LiveFitResult> fitted = fitters_.at(request.shapes[i]->id).run(one, control);
    if (!fitted) return;
    problems[i] = fitted->problem;
    if (!fitted->fit) return;
    StripFit fit{*fitted->fit, strip_colours(*request.shapes[i], *request.part_template, fitted->fit->fit)};
    fit.view.part_template = request.part_template;
    result.fits[i] = std::make_shared<const StripFit>(std::move(fit));
  });
  if (!whole || control.cancelled()) return std::nullopt;
  for (const auto& shape : request.shapes) result.shapes.push_back(shape->id);
  for (const std::string& problem : problems)
    if (result.problem.empty()) result.problem = problem;
  result.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace archetype
