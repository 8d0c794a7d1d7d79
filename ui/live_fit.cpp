#include "ui/live_fit.h"

#include <chrono>
#include <exception>
#include <limits>

#include "core/fitting/fit_template.h"
#include "core/fitting/point_graph.h"
#include "core/fitting/sample_costs.h"
#include "core/fitting/template_surface.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// A fit can only be gone on from if it is of the same shape and has the same parts, moved.
bool can_go_on(const LiveFitRequest& request) {
  return request.dragging && request.start && request.start->fit.labels.size() == request.samples->size() &&
         request.start->fit.parts.size() == request.part_template->parts.size();
}

// A box or two may fit a shape at every yaw nearly alike; which is best then changes from edit to edit, and
// the shape would turn in the view each time. Another yaw than the one shown has to be better by this share.
constexpr double yaw_margin = 0.01;

std::optional<ShapeFit> fit_at_shown_yaw(const PartTemplate& part_template, const LiveFitRequest& request,
                                         const JobControl& control) {
  const int shown = request.start ? request.start->fit.yaw_quarters : 0;
  FitOptions options = request.options;
  options.yaw_costs.fill(std::numeric_limits<double>::infinity());
  options.yaw_costs[static_cast<std::size_t>(shown)] = 0;
  return fit_template(part_template, *request.samples, options, control, nullptr, request.pinned);
}

std::optional<ShapeFit> fit_at_any_yaw(const PartTemplate& part_template, const LiveFitRequest& request,
                                       const JobControl& control) {
  std::optional<ShapeFit> fit =
      fit_template(part_template, *request.samples, request.options, control, nullptr, request.pinned);
  const int shown = request.start ? request.start->fit.yaw_quarters : 0;
  if (!fit || fit->yaw_quarters == shown) return fit;
  const auto energy_at = [&](int yaw) { return fit->yaw_energies[static_cast<std::size_t>(yaw)]; };
  if (energy_at(shown) * (1 - yaw_margin) > energy_at(fit->yaw_quarters)) return fit;
  std::optional<ShapeFit> same = fit_at_shown_yaw(part_template, request, control);
  if (same) same->yaw_energies = fit->yaw_energies;
  return same;
}

}  // namespace

std::shared_ptr<const PartTemplate> ExpectedFeatures::of(
    const std::shared_ptr<const PartTemplate>& part_template) {
  const std::lock_guard lock(mutex_);
  if (asked_ != part_template) {
    made_ = std::make_shared<const PartTemplate>(with_expected_features(*part_template));
    asked_ = part_template;
  }
  return made_;
}

const LabellingGraph& LiveFitter::graph(const LiveFitRequest& request) {
  if (graph_samples_ != request.samples) {
    graph_ = make_point_graph(*request.samples, request.options);
    graph_samples_ = request.samples;
  }
  return graph_;
}

std::vector<std::int16_t> LiveFitter::label(const PartTemplate& expecting, const LiveFitRequest& request,
                                            const ShapeFit& fit, const JobControl& control) {
  if (!labeller_ || mesh_ != request.mesh || samples_ != request.samples) {
    labeller_.emplace(*request.mesh, *request.samples, request.options, control);
    mesh_ = request.mesh;
    samples_ = request.samples;
  }
  if (control.cancelled()) {
    labeller_.reset();  // it may be half made
    return {};
  }
  return labeller_->label(expecting, fit, control, request.pinned);
}

std::optional<LiveFitResult> LiveFitter::run(const LiveFitRequest& request, const JobControl& control) {
  LiveFitResult result;
  result.document_revision = request.document_revision;
  result.shape_revision = request.shape_revision;
  try {
    const Clock::time_point start = Clock::now();
    // A tenth of what following a fit takes: once for all that asks for it.
    const std::shared_ptr<const PartTemplate> expecting = expected_->of(request.part_template);
    const PartTemplate& part_template = *expecting;
    std::optional<ShapeFit> fit =
        can_go_on(request) ? follow_template(part_template, *request.samples, graph(request),
                                             request.start->fit, request.options, control, request.pinned)
        : request.keep_yaw ? fit_at_shown_yaw(part_template, request, control)
                           : fit_at_any_yaw(part_template, request, control);
    if (!fit) return std::nullopt;
    result.fit_milliseconds = milliseconds_since(start);

    const Clock::time_point labelling = Clock::now();
    ViewFit view{request.part_template, std::move(*fit), {}, {}, {}};
    if (request.costs)
      view.sample_costs = sample_costs(part_template, *request.samples, view.fit, request.options);
    if (request.mesh) view.element_labels = label(part_template, request, view.fit, control);
    if (request.costs && labeller_ && request.mesh)
      view.element_costs = labeller_->interpolate(view.sample_costs);
    result.label_milliseconds = milliseconds_since(labelling);
    result.fit = std::make_shared<const ViewFit>(std::move(view));
  } catch (const std::exception& error) {
    result.problem = error.what();
  }
  if (control.cancelled()) return std::nullopt;
  return result;
}

}  // namespace archetype
