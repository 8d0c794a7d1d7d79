// Which points are wanted, and when they are read again.
#include "ui/cloud_view.h"

#include <algorithm>
#include <bit>

#include "core/base/random.h"
#include "core/base/sort_unique.h"
#include "core/session/same_part.h"
#include "ui/studio.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

// While a job writes fits, the cloud follows, but leaves it most of the processor.
constexpr std::chrono::seconds pause_while_working{10};

}  // namespace

CloudShapes wanted_shapes(const Studio& studio) {
  const CloudChoice& choice = studio.ui.cloud;
  const bool selection = choice.scope == CloudScope::selection;
  CloudShapes wanted{studio.collection.path, {}, 0, 0};
  for (const ShapeRow& row : studio.collection.rows()) {
    if (!row.fit) continue;
    if (selection && !is_selected(studio.ui.selection, row.id)) continue;
    if (choice.scope == CloudScope::cluster && row.fit->part_template != choice.cluster) continue;
    if (!selection && row.fit->status == FitStatus::outlier) {
      ++wanted.outliers;
      continue;
    }
    wanted.shapes.push_back(row.id);
    const auto energy = std::bit_cast<std::uint64_t>(row.fit->energy.total());
    wanted.revision = derive_seed(wanted.revision ^ row.fit->state.words[0], energy);
  }
  return wanted;
}

namespace {

// A cluster goes when its template does.
void keep_choice_valid(Studio& studio) {
  CloudChoice& choice = studio.ui.cloud;
  if (choice.scope != CloudScope::cluster) return;
  const auto& rows = studio.collection.rows();
  const bool there = std::ranges::any_of(
      rows, [&](const ShapeRow& row) { return row.fit && row.fit->part_template == choice.cluster; });
  if (!there) choice.scope = CloudScope::collection;
}

void ask(Studio& studio) {
  CloudView& view = studio.cloud;
  CloudShapes wanted = wanted_shapes(studio);
  const bool same_shapes = wanted.project == view.asked.project && wanted.shapes == view.asked.shapes;
  if (same_shapes && (wanted.revision == view.asked.revision || wanted.shapes.empty())) {
    view.asked.outliers = wanted.outliers;
    return;
  }
  const bool working = !studio.jobs.resting();
  const bool same_project = wanted.project == view.asked.project;
  if (working && same_project && Clock::now() - view.asked_at < pause_while_working) return;
  view.asked = std::move(wanted);
  view.asked_at = Clock::now();
  if (!same_project) view.content.reset();
  if (view.asked.shapes.empty()) {
    view.reader.cancel();
    view.content.reset();
    return;
  }
  view.progress = std::make_shared<CloudProgress>();
  CloudContentRequest request{view.asked.project, {.shapes = view.asked.shapes}, view.progress};
  request.what.threads = static_cast<unsigned>(studio.settings.threads);
  view.reader.request(std::move(request), true);
}

// For cloud_colours(): the picked part in each template.
std::vector<int> kept_parts(const CloudContent& content, const std::optional<PartOfTemplate>& picked) {
  if (!picked) return {};
  const auto of = std::ranges::find(content.templates, picked->part_template, &TemplateRecord::id);
  if (of == content.templates.end()) return {};
  std::vector<int> kept;
  for (const TemplateRecord& each : content.templates) {
    const auto same = find_same_part(of->part_template, picked->part, each.part_template);
    kept.push_back(same ? static_cast<int>(*same) : no_such_part);
  }
  return kept;
}

void follow_colours(Studio& studio) {
  CloudView& view = studio.cloud;
  const std::tuple wanted{static_cast<const CloudContent*>(view.content.get()), studio.ui.cloud.colour,
                          studio.ui.selection.part};
  if (view.coloured == wanted) return;
  view.coloured = wanted;
  view.colours = view.content ? cloud_colours(*view.content, studio.ui.cloud.colour,
                                              kept_parts(*view.content, studio.ui.selection.part))
                              : nullptr;
}

// The selected shapes, and the one under the mouse in whichever panel.
void follow_marks(Studio& studio, bool other_content) {
  CloudView& view = studio.cloud;
  std::vector<std::uint32_t> shapes;
  if (view.content) {
    const auto add = [&](ShapeId id) {
      if (const auto number = shape_in_cloud(*view.content, id)) shapes.push_back(*number);
    };
    if (studio.ui.cloud.scope != CloudScope::selection)
      for (const ShapeId id : studio.ui.selection.shapes) add(id);
    if (studio.ui.selection.hovered) add(*studio.ui.selection.hovered);
    sort_unique(shapes);
  }
  if (shapes == view.marked_shapes && !other_content) return;
  view.marked = shapes.empty() ? nullptr : points_of_shapes(*view.content, shapes);
  view.marked_shapes = std::move(shapes);
}

}  // namespace

std::optional<std::uint32_t> shape_in_cloud(const CloudContent& content, ShapeId id) {
  const auto found = std::ranges::find(content.shapes, id, &CloudShape::id);
  if (found == content.shapes.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - content.shapes.begin());
}

void follow_cloud(Studio& studio) {
  CloudView& view = studio.cloud;
  keep_choice_valid(studio);
  bool other_content = false;
  if (auto read = view.reader.poll()) {
    view.content = std::move(*read);
    other_content = true;
  }
  const std::shared_ptr<const CloudContent> before = view.content;
  if (const std::string problem = view.reader.take_problem(); !problem.empty())
    say(studio, Severity::error, "the points cannot be read: " + problem);
  ask(studio);
  other_content = other_content || before != view.content;
  follow_colours(studio);
  follow_marks(studio, other_content);
}

bool cloud_busy(const Studio& studio) {
  const CloudView& view = studio.cloud;
  if (studio.ui.centre != CentreView::cloud) return false;
  if (!view.reader.idle() || view.turning > 0 || view.flight) return true;
  // A click or a command of this frame may want other points.
  const bool same_project = view.asked.project == studio.collection.path;
  if (studio.collection.open() && studio.jobs.resting()) {
    const CloudShapes wanted = wanted_shapes(studio);
    const bool same =
        same_project && view.asked.revision == wanted.revision && view.asked.shapes == wanted.shapes;
    if (!same && !wanted.shapes.empty()) return true;
  }
  for (std::size_t i = 0; i < view.shown; ++i)
    if (view.content && !view.pictures[i].whole) return true;
  return false;
}

}  // namespace archetype
