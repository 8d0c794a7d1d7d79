#include "ui/live_fit.h"

#include <chrono>
#include <exception>

#include "core/fitting/fit_template.h"

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

}  // namespace

std::vector<std::int16_t> LiveFitter::label(const LiveFitRequest& request, const ShapeFit& fit) {
  if (!labeller_ || mesh_ != request.mesh || samples_ != request.samples) {
    labeller_.emplace(*request.mesh, *request.samples, request.options);
    mesh_ = request.mesh;
    samples_ = request.samples;
  }
  return labeller_->label(*request.part_template, fit);
}

std::optional<LiveFitResult> LiveFitter::run(const LiveFitRequest& request, const JobControl& control) {
  LiveFitResult result;
  result.document_revision = request.document_revision;
  result.shape_revision = request.shape_revision;
  try {
    const Clock::time_point start = Clock::now();
    const PartTemplate& part_template = *request.part_template;
    std::optional<ShapeFit> fit =
        can_go_on(request)
            ? refit_template(part_template, *request.samples, request.start->fit, request.options, control)
            : fit_template(part_template, *request.samples, request.options, control);
    if (!fit) return std::nullopt;
    result.fit_milliseconds = milliseconds_since(start);

    const Clock::time_point labelling = Clock::now();
    ViewFit view{request.part_template, std::move(*fit), {}};
    if (request.mesh) view.element_labels = label(request, view.fit);
    result.label_milliseconds = milliseconds_since(labelling);
    result.fit = std::make_shared<const ViewFit>(std::move(view));
  } catch (const std::exception& error) {
    result.problem = error.what();
  }
  if (control.cancelled()) return std::nullopt;
  return result;
}

}  // namespace archetype
