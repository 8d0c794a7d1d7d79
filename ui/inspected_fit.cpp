#include "ui/inspected_fit.h"

#include <algorithm>
#include <exception>

#include "core/session/fit_state.h"
#include "core/session/yaw_votes.h"
#include "ui/shape_loader.h"

namespace archetype {
namespace {

constexpr std::size_t most_cluster_shapes = 200;  // more would not move the percentiles

// The display that picks need a tree for.
ShapeDisplay pickable_display(const InspectedShape& shape, const JobControl& control) {
  std::optional<ShapeDisplay> made =
      make_shape_display({shape.mesh, shape.samples, shape.record.frame, 1}, control);
  if (!made) return {};
  if (made->mesh) {
    MeshGeometry geometry = *made->mesh;
    geometry.tree = TriangleTree(geometry.positions);
    made->mesh = std::make_shared<const MeshGeometry>(std::move(geometry));
  }
  return std::move(*made);
}

std::uint32_t nearest_sample(const ShapeSamples& samples, const Vec3& point) {
  const auto nearest =
      std::ranges::min_element(samples.points, {}, [&](const Vec3& p) { return (p - point).squaredNorm(); });
  return static_cast<std::uint32_t>(nearest - samples.points.begin());
}

void add_places(FitLook& look) {
  const LabelledSurface surface{*look.shape->mesh, look.shape->record.frame, look.fit, look.element_labels};
  look.to_template.emplace(surface, *look.part_template);
  look.to_surface.emplace(surface, *look.part_template);
}

}  // namespace

std::optional<LoadedInspected> load_inspected(const LoadInspected& request, const JobControl& control) {
  LoadedInspected loaded{request, nullptr, {}};
  try {
    std::optional<LoadedShape> file = load_shape({request.project, request.shape}, control);
    if (!file) return std::nullopt;
    const Project project = Project::open(request.project);
    if (!file->shape.record || !file->shape.samples) {
      loaded.problem = file->shape.problem;
      return loaded;
    }
    auto shape = std::make_shared<InspectedShape>();
    shape->record = *file->shape.record;
    shape->samples = file->shape.samples;
    shape->mesh = file->shape.mesh;
    shape->templates = project.templates();
    std::vector<PartTemplate> current;
    for (const TemplateRecord& each : shape->templates) current.push_back(each.part_template);
    shape->state = fit_state(current, {});
    shape->fit = project.fit(request.shape);
    if (shape->fit) {
      std::optional<TemplateRecord> of = project.find_template(shape->fit->part_template);
      if (of) shape->part_template = std::make_shared<const PartTemplate>(std::move(of->part_template));
      if (auto labels = project.labels(request.shape)) shape->element_labels = std::move(*labels);
    }
    shape->display = pickable_display(*shape, control);
    if (control.cancelled()) return std::nullopt;
    loaded.shape = std::move(shape);
  } catch (const std::exception& error) {
    loaded.problem = error.what();
  }
  return loaded;
}

std::optional<LookResult> FitLooker::run(const LookRequest& request, const JobControl& control) {
  LookResult result{request, nullptr};
  const InspectedShape& shape = *request.shape;
  if (shape_ != request.shape) {
    labeller_.reset();
    shape_ = request.shape;
    if (shape.mesh) labeller_.emplace(*shape.mesh, *shape.samples, FitOptions{}, control);
    if (control.cancelled()) {
      shape_.reset();
      return std::nullopt;
    }
  }
  auto look = std::make_shared<FitLook>();
  look->shape = request.shape;
  look->part_template = request.part_template;
  look->fit = *request.fit;
  look->terms = inspect_fit(*request.part_template, *shape.samples, look->fit, FitOptions{});
  if (labeller_) {
    look->element_labels = labeller_->label(*request.part_template, look->fit, control, request.pinned);
    const std::array values{&look->terms.shape_to_template, &look->terms.features, &look->terms.smoothness};
    for (std::size_t i = 0; i < values.size(); ++i)
      look->element_terms[i] = labeller_->interpolate(*values[i]);
  }
  if (control.cancelled()) return std::nullopt;
  if (labeller_ && request.places) add_places(*look);
  result.look = std::move(look);
  return result;
}

std::optional<PartPoint> place_on_template(const FitLook& look, const Vec3& point) {
  if (look.to_template) return look.to_template->locate(look.shape->record.frame.to_file(point));
  const std::int16_t label = look.fit.labels[nearest_sample(*look.shape->samples, point)];
  if (label == null_label) return std::nullopt;
  const auto part = static_cast<std::size_t>(label);
  PartPoint place;
  place.part = label;
  place.local = look.fit.parts[part].box.to_local(look.fit.to_template(point));
  place.on_mean = look.part_template->parts[part].mean_box().to_world(place.local);
  return place;
}

std::optional<Vec3> place_on_shape(const FitLook& look, const PartTemplate& from, const PartPoint& place) {
  PartPoint own = place;
  own.part = counterpart(from, place.part, *look.part_template);
  if (look.to_surface) {
    const auto found = look.to_surface->find(own);
    if (!found) return std::nullopt;
    return look.shape->record.frame.to_normalised(found->position);
  }
  if (own.part < 0 || !look.fit.parts[static_cast<std::size_t>(own.part)].present) return std::nullopt;
  const Vec3 wanted =
      look.fit.to_shape(look.fit.parts[static_cast<std::size_t>(own.part)].box.to_world(own.local));
  std::optional<Vec3> nearest;
  for (std::size_t i = 0; i < look.shape->samples->size(); ++i) {
    const Vec3& p = look.shape->samples->points[i];
    if (look.fit.labels[i] != own.part) continue;
    if (!nearest || (p - wanted).squaredNorm() < (*nearest - wanted).squaredNorm()) nearest = p;
  }
  return nearest;
}

std::optional<std::shared_ptr<const Alternatives>> make_alternatives(const AlternativesRequest& request,
                                                                     const JobControl& control) {
  auto made = std::make_shared<Alternatives>();
  made->of = request;
  std::vector<PartTemplate> templates;
  for (const TemplateRecord& each : request.shape->templates) {
    templates.push_back(each.part_template);
    made->templates.push_back(std::make_shared<const PartTemplate>(each.part_template));
  }
  auto fits = fit_alternatives(templates, *request.shape->samples, request.pinned, {}, control);
  if (!fits) return std::nullopt;
  made->fits = std::move(*fits);
  try {
    made->yaw_costs = kept_yaw_costs(Project::open(request.project), request.shape->record.id, control);
  } catch (const std::exception&) {
    // The job that is writing the project says what is wrong.
  }
  if (control.cancelled()) return std::nullopt;
  return made;
}

std::optional<ClusterResult> read_cluster(const ClusterRequest& request, const JobControl& control) {
  ClusterResult result{request, {}};
  try {
    auto terms = cluster_terms(Project::open(request.project), request.part_template, most_cluster_shapes,
                               FitOptions{}, control);
    if (!terms) return std::nullopt;
    result.terms = std::move(*terms);
  } catch (const std::exception&) {
    // The job that is writing the project says what is wrong.
  }
  return result;
}

}  // namespace archetype
