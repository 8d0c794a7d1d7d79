// What goes on from frame to frame: results are taken over, new work is handed out.
#include "ui/studio.h"

#include <algorithm>
#include <utility>

#include "core/fitting/pinned_labels.h"
#include "ui/kept_choices.h"
#include "ui/learning_actions.h"
#include "ui/linked_part.h"
#include "ui/selection.h"

namespace archetype {
namespace {

using Clock = std::chrono::steady_clock;

void take_over_shape(Studio& studio) {
  std::optional<LoadedShape> loaded = studio.shape_loader.poll();
  if (!loaded || !loaded->shape.record || studio.ui.shape != loaded->shape.record->id) {
    if (loaded && !loaded->shape.problem.empty()) studio.messages.error(loaded->shape.problem);
    return;
  }
  const std::uint64_t revision = studio.shape.shape_revision + 1;
  const std::uint64_t fit_revision = studio.shape.fit_revision + 1;
  studio.shape = std::move(loaded->shape);
  studio.shape.shape_revision = revision;
  studio.shape.fit_revision = fit_revision;
  if (!studio.shape.problem.empty()) say(studio, Severity::warning, studio.shape.problem);
}

// A fit that comes just after a frame has begun would be seen one frame later: while a box is dragged, a
// frame rather begins a little later. It also leaves the processor to the fit where OpenGL takes all of it.
constexpr std::chrono::milliseconds patience{15};

void take_over_fit(Studio& studio) {
  LiveFit& live = studio.live_fit;
  if (studio.history.has_preview()) live.worker.wait(patience);
  std::optional<LiveFitResult> result = live.worker.poll();
  if (!result || result->shape_revision != studio.shape.shape_revision) return;
  if (!result->problem.empty()) say(studio, Severity::error, result->problem);
  studio.shape.fit = std::move(result->fit);
  ++studio.shape.fit_revision;
  live.shown_document = result->document_revision;
  live.newly_shown = true;
  live.fit_milliseconds = result->fit_milliseconds;
  live.label_milliseconds = result->label_milliseconds;
}

void drop_fit(Studio& studio) {
  studio.live_fit.worker.cancel();
  studio.live_fit.asked_document = 0;
  studio.latency.forget_open();
  if (!studio.shape.fit) return;
  studio.shape.fit.reset();
  ++studio.shape.fit_revision;
}

// Asks for the fit of what is shown now, once for each state. The end of a drag is a state of its own: then
// all yaws are tried.
void ask_for_fit(Studio& studio) {
  const std::shared_ptr<const PartTemplate> shown = shown_template(studio);
  if (!shown || shown->parts.empty() || !studio.shape.samples) {
    drop_fit(studio);
    studio.live_fit.asked_shape = studio.shape.shape_revision;
    return;
  }
  LiveFit& live = studio.live_fit;
  const std::uint64_t revision = studio.history.revision();
  const bool other_shape = live.asked_shape != studio.shape.shape_revision;
  const std::shared_ptr<const PartTemplate> look = studio.ui.look ? shown : nullptr;
  const bool other_look = live.asked_look != look;
  if (live.asked_document == revision && !other_shape && !other_look) return;
  LiveFitRequest request;
  request.part_template = shown;
  request.samples = studio.shape.samples;
  request.mesh = studio.shape.mesh;
  request.start = studio.shape.fit;
  request.keep_yaw = !look && stands_as_shown(studio);
  request.dragging = studio.history.has_preview();
  // While something is dragged only what is seen is computed; at rest all, since the heat map may be next.
  request.costs = !request.dragging || studio.ui.view.colour == SurfaceColour::cost;
  request.document_revision = revision;
  request.shape_revision = studio.shape.shape_revision;
  const ShapeCorrection* correction =
      studio.ui.shape ? correction_of(studio.history.current(), *studio.ui.shape) : nullptr;
  if (correction && correction->yaw_quarters) {
    request.options.yaw_costs = pinned_yaw_costs({}, *correction);
    request.keep_yaw = false;
    // Turned by hand it does not stand as it was drawn on; when it is free again, its yaw is found anew.
    if (studio.shape.fit && studio.shape.fit->fit.yaw_quarters != *correction->yaw_quarters)
      studio.ui.points.made_on = 0;
  }
  if (correction && studio.shape.record && correction->sampling == sampling_of(*studio.shape.record))
    request.pinned = pinned_labels(correction->pinned, *shown, studio.shape.samples->size());
  live.worker.request(std::move(request), other_shape || other_look);
  live.asked_look = look;
  live.asked_document = revision;
  live.asked_shape = studio.shape.shape_revision;
}

// The edit came in with the events that were handled just before this frame.
void note_edit(Studio& studio) {
  Autosave& saving = studio.autosave;
  if (studio.history.revision() == saving.edited_revision) return;
  saving.edited_revision = studio.history.revision();
  stop_looking(studio);
  if (studio.shape.samples) studio.latency.edited(saving.edited_revision, studio.frame_start);
}

void keep_selection_valid(Studio& studio) {
  const PartTemplate* active = studio.history.current().active_template();
  keep_selection_within(studio.ui, active ? active->parts.size() : 0);
}

Navigation parse_navigation(const std::string& name) {
  return name == "blender" ? Navigation::blender : name == "maya" ? Navigation::maya : Navigation::archetype;
}

// The file of the shape in view was imported again because it has changed.
void follow_changed_file(Studio& studio) {
  const std::optional<ShapeRecord>& shown = studio.shape.record;
  if (!shown || studio.ui.shape != shown->id || !studio.shape_loader.idle()) return;
  const std::optional<std::size_t> row = find_row(studio.collection, shown->id);
  if (row && studio.collection.rows()[*row].hash != shown->hash)
    studio.shape_loader.request({studio.collection.path, shown->id}, true);
}

// What a worker could not do, and no result says.
void tell_problems(Studio& studio) {
  for (const std::string& problem :
       {studio.shape_loader.take_problem(), studio.live_fit.worker.take_problem(),
        studio.region_worker.take_problem(), studio.directory_reader.take_problem(),
        studio.viewport.coarse_worker.take_problem(), studio.viewport.average_worker.take_problem(),
        studio.thumbnails.take_problem(), studio.fit_tables.reader.take_problem(),
        studio.shape_map.maker.take_problem()})
    if (!problem.empty()) say(studio, Severity::error, problem);
}

// A learning that starts over has no rounds before it, whatever the project told when it was asked for.
void note_rounds(Studio& studio) {
  const std::size_t rounds = rounds_learned(studio);
  for (ProjectWriter& writer : studio.writers)
    if (writer.project == studio.collection.path)
      writer.rounds_before = std::min(writer.rounds_before, rounds);
}

// While something writes to the project, its rows are read anew twice a second.
void follow_rows(Studio& studio) {
  if (std::optional<CollectionRows> rows = studio.rows_reader.poll()) {
    studio.collection.content = std::move(*rows);
    ++studio.collection.revision;
    note_rounds(studio);
    if (!studio.ui.shape && !studio.collection.rows().empty())
      show_shape(studio, studio.collection.rows()[0].id);
    follow_changed_file(studio);
  }
  // Once more when all are paused: what came just before.
  const bool resting = studio.jobs.resting();
  if (!studio.collection.open() || studio.jobs.idle() || (resting && studio.rows_are_of_pause)) return;
  if (Clock::now() - studio.rows_asked_at < std::chrono::milliseconds(500)) return;
  studio.rows_asked_at = Clock::now();
  studio.rows_are_of_pause = resting;
  studio.rows_reader.request(studio.collection.path, false);
}

// An edit is told of at the bottom, unless who made it has said more; what was told before is of the past.
void tell_edit(Studio& studio) {
  const History& history = studio.history;
  const bool edited = history.committed_revision() != studio.ui.told_revision;
  const bool newest = history.position() > 0 && !history.can_redo();  // undo tells of itself
  if (edited && newest && studio.ui.status == studio.ui.told_status)
    studio.ui.status = "Done: " + history.entries().back().message;
  studio.ui.told_revision = history.committed_revision();
  studio.ui.told_status = studio.ui.status;
}

}  // namespace

Studio::Studio(StudioOptions given)
    : options(std::move(given)),
      commands(all_commands()),
      viewport(options.shaders, options.wake),
      cloud(options.wake),
      shape_loader(load_shape, options.wake),
      rows_reader(reread_rows, options.wake),
      fit_tables(options.wake),
      shape_map(options.wake),
      autosave(options.wake),
      directory_reader(list_directory, options.wake),
      live_fit(expected_features, options.wake),
      strip(expected_features, options.wake),
      inspection(options.wake),
      region_worker(find_surface_regions, options.wake),
      thumbnails(options.shaders, options.wake),
      jobs(options.wake) {}

void begin_frame(Studio& studio) {
  studio.frame_start = Clock::now();
  studio.ui.navigation = parse_navigation(studio.settings.navigation);
  follow_kept_choices(studio);
  for (const JobView& ended : studio.jobs.poll()) {
    std::erase_if(studio.writers, [&](const ProjectWriter& writer) { return writer.job == ended.id; });
    if (ended.state == JobState::failed) say(studio, Severity::error, ended.title + ": " + ended.error);
    if (studio.collection.open()) studio.rows_reader.request(studio.collection.path, false);
  }
  if (auto listing = studio.directory_reader.poll()) studio.directory = std::move(listing);
  if (auto regions = studio.region_worker.poll()) studio.ui.points.regions = std::move(*regions);
  studio.thumbnails.begin_frame(studio.collection.path);
  studio.thumbnails.follow_colours(studio.history.committed());
  follow_rows(studio);
  take_over_shape(studio);
  take_over_fit(studio);
  begin_fit_tables(studio);
  begin_shape_map(studio);
  begin_strip(studio);
  begin_inspection(studio);
  tell_problems(studio);
  studio.ui.selection.hovered = std::exchange(studio.ui.selection.hovering, std::nullopt);
  keep_selection_valid(studio);
  link_selected_part(studio);
  if (studio.drag && !advance(*studio.drag, studio.history)) studio.drag.reset();
  if (studio.scroll && !advance(*studio.scroll, studio.ui, studio.fonts.scale)) studio.scroll.reset();
}

void end_frame(Studio& studio) {
  note_edit(studio);
  tell_edit(studio);
  keep_selection_valid(studio);
  ask_for_fit(studio);
  end_strip(studio);
  follow_corrections(studio);
  end_inspection(studio);
  end_fit_tables(studio);
  studio.thumbnails.end_frame();
  autosave(studio);
  follow_closing(studio);
}

void frame_shown(Studio& studio) {
  const Clock::time_point now = Clock::now();
  studio.frames.shown(std::chrono::duration<double, std::milli>(now - studio.frame_start).count());
  studio.opening.frame_shown(now);
  strip_shown(studio, now);
  if (!std::exchange(studio.live_fit.newly_shown, false)) return;
  studio.latency.displayed(studio.live_fit.shown_document, now);
}

std::string_view under_way(const Studio& studio) {
  const bool shape_shown = studio.ui.centre == CentreView::shape;
  const std::pair<bool, std::string_view> all[]{
      {studio.drag.has_value(), "a drag"},
      {studio.scroll.has_value(), "a scroll"},
      {studio.wanted_picture.has_value(), "a picture of the window"},
      {!studio.jobs.resting(), "a job"},
      {!studio.shape_loader.idle(), "reading the shape"},
      {!studio.region_worker.idle(), "regions of the surface"},
      {!studio.rows_reader.idle(), "reading the collection"},
      {!studio.directory_reader.idle(), "reading a folder"},
      {!studio.autosave.saver.idle(), "saving"},
      {!studio.thumbnails.idle(), "thumbnails"},
      {!studio.live_fit.worker.idle() || studio.live_fit.newly_shown ||
           studio.live_fit.asked_shape != studio.shape.shape_revision,
       "the live fit"},
      {!strip_settled(studio), "the strip"},
      {!fit_tables_settled(studio), "tables of fits"},
      {!corrections_settled(studio), "corrections"},
      {!inspection_settled(studio), "the inspection"},
      {cloud_busy(studio), "the cloud"},
      {!studio.shape_map.maker.idle(), "the map"},
      {shape_shown && viewport_busy(studio.viewport, studio.shape.shape_revision), "the viewport"}};
  for (const auto& [busy, what] : all)
    if (busy) return what;
  return "";
}

bool settled(const Studio& studio) {
  return under_way(studio).empty();
}

bool wants_frames(const Studio& studio) {
  return !settled(studio) || unsaved(studio) || !studio.autosave.waiting.empty();
}

const Palette& colours(const Studio& studio) {
  return palette(studio.theme);
}

void show_shape(Studio& studio, std::optional<ShapeId> shape) {
  // A click on a shape whose file could not be read tries again.
  if (studio.ui.shape == shape && shape && studio.shape.problem.empty()) return;
  studio.ui.shape = shape;
  if (shape) {
    studio.shape_loader.request({studio.collection.path, *shape}, true);
    return;
  }
  studio.shape_loader.cancel();
  ShapeInView none;
  none.shape_revision = studio.shape.shape_revision + 1;
  none.fit_revision = studio.shape.fit_revision + 1;
  studio.shape = std::move(none);
}

void say(Studio& studio, Severity severity, std::string text) {
  studio.ui.status = text;
  studio.messages.add(severity, std::move(text));
}

}  // namespace archetype
