// What goes on in the strip from frame to frame.
#include "ui/shape_strip.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/random.h"
#include "ui/studio.h"

namespace archetype {
namespace {

bool is_of(const StripTile& tile, ShapeId id) {
  return tile.id == id;
}

// Takes the tiles that are still wanted along. Only before the panels: what the frame draws has to stay.
void follow_members(Studio& studio) {
  ShapeStrip& strip = studio.strip;
  StripChoice& choice = studio.ui.strip;
  if (!studio.collection.open()) choice = {};
  if (strip.project != studio.collection.path) {
    strip.project = studio.collection.path;
    strip.tiles.clear();
    strip.loader.cancel();
    strip.loading.reset();
    ++strip.tiles_revision;
  }
  if (std::ranges::equal(strip.tiles, choice.shapes, is_of)) return;
  std::vector<StripTile> tiles;
  for (const ShapeId id : choice.shapes) {
    const auto old = std::ranges::find(strip.tiles, id, &StripTile::id);
    if (old != strip.tiles.end()) {
      tiles.push_back(std::move(*old));
      old->id = 0;  // the same shape is not there twice
    } else {
      tiles.emplace_back().id = id;
    }
  }
  strip.tiles = std::move(tiles);
  ++strip.tiles_revision;
}

void fill_when_empty(Studio& studio) {
  StripChoice& choice = studio.ui.strip;
  if (!choice.shapes.empty() || choice.emptied || studio.collection.rows().size() < 2) return;
  if (!studio.jobs.idle()) return;  // shapes are still being read
  fill_strip_with_worst(studio);
}

void take_over_loaded(ShapeStrip& strip) {
  const std::optional<LoadedStripShape> loaded = strip.loader.poll();
  if (!loaded) {
    if (strip.loader.idle()) strip.loading.reset();
    return;
  }
  strip.loading.reset();
  const auto tile = std::ranges::find(strip.tiles, (*loaded)->id, &StripTile::id);
  if (tile == strip.tiles.end()) return;
  tile->shape = *loaded;
  tile->fit.reset();
  ++strip.tiles_revision;
}

// One after the other, from the left to the right.
void ask_for_shapes(ShapeStrip& strip) {
  if (strip.loading) return;
  for (const StripTile& tile : strip.tiles) {
    if (tile.shape) continue;
    strip.loading = tile.id;
    strip.loader.request({strip.project, tile.id}, true);
    return;
  }
}

bool can_be_fitted(const StripTile& tile) {
  return tile.shape && tile.shape->samples;
}

void take_over_fits(Studio& studio) {
  ShapeStrip& strip = studio.strip;
  const std::optional<StripFitResult> result = strip.fitter.poll();
  if (!result) return;
  for (std::size_t i = 0; i < result->shapes.size(); ++i) {
    const auto tile = std::ranges::find(strip.tiles, result->shapes[i], &StripTile::id);
    if (tile != strip.tiles.end() && result->fits[i]) tile->fit = result->fits[i];
  }
  if (!result->problem.empty()) say(studio, Severity::error, result->problem);
  strip.fit_milliseconds = result->milliseconds;
  strip.shown_document = result->document_revision;
  strip.newly_shown = true;
}

// The energies that changes are counted from, and when the edit came in.
void note_edit(Studio& studio) {
  ShapeStrip& strip = studio.strip;
  const std::uint64_t revision = studio.history.revision();
  if (revision == strip.seen_document) return;
  const bool begins = !strip.seen_preview;
  strip.seen_document = revision;
  strip.seen_preview = studio.history.has_preview();
  if (begins)
    for (StripTile& tile : strip.tiles) {
      tile.energy_before.reset();
      if (tile.fit) tile.energy_before = energy_without_missing(tile.fit->view).total();
    }
  if (std::ranges::any_of(strip.tiles, can_be_fitted)) strip.latency.edited(revision, studio.frame_start);
}

void drop_fits(ShapeStrip& strip) {
  strip.fitter.cancel();
  strip.latency.forget_open();
  strip.asked_document = 0;
  for (StripTile& tile : strip.tiles) {
    tile.fit.reset();
    tile.energy_before.reset();
  }
}

void ask_for_fits(Studio& studio) {
  ShapeStrip& strip = studio.strip;
  StripFitRequest request;
  request.part_template = shown_template(studio);
  if (!request.part_template || request.part_template->parts.empty()) {
    if (strip.asked_document != 0) drop_fits(strip);
    return;
  }
  request.document_revision = studio.history.revision();
  request.dragging = studio.history.has_preview();
  const bool other_tiles = strip.asked_tiles != strip.tiles_revision;
  const auto look = studio.ui.look ? request.part_template : nullptr;
  // With the first boxes of a template any yaw fits as well as another: the shapes would turn at every one.
  request.keep_yaw = !look && stands_as_shown(studio);
  const bool other_look = look != strip.asked_look;
  if (strip.asked_document == request.document_revision && !other_tiles && !other_look) return;
  for (const StripTile& tile : strip.tiles) {
    if (!can_be_fitted(tile)) continue;
    request.shapes.push_back(tile.shape);
    request.starts.push_back(tile.fit);
  }
  // A fit at all yaws of the edit before would keep a drag waiting that has just begun.
  const bool stale = other_look || (request.dragging && !strip.asked_dragging);
  strip.asked_tiles = strip.tiles_revision;
  strip.asked_document = request.document_revision;
  strip.asked_look = look;
  strip.asked_dragging = request.dragging;
  if (!request.shapes.empty()) strip.fitter.request(std::move(request), stale);
}

}  // namespace

bool strip_in_sight(const Studio& studio) {
  return studio.settings.show_bottom && studio.ui.bottom_tab == BottomTab::strip;
}

void begin_strip(Studio& studio) {
  ShapeStrip& strip = studio.strip;
  follow_members(studio);
  take_over_loaded(strip);
  take_over_fits(studio);
  for (const std::string& problem : {strip.loader.take_problem(), strip.fitter.take_problem()})
    if (!problem.empty()) say(studio, Severity::error, problem);
}

void end_strip(Studio& studio) {
  if (!strip_in_sight(studio)) {
    studio.strip.latency.forget_open();
    return;
  }
  fill_when_empty(studio);
  note_edit(studio);
  ask_for_shapes(studio.strip);
  ask_for_fits(studio);
}

void strip_shown(Studio& studio, LatencyMeter::Clock::time_point now) {
  if (std::exchange(studio.strip.newly_shown, false))
    studio.strip.latency.displayed(studio.strip.shown_document, now);
}

bool strip_settled(const Studio& studio) {
  const ShapeStrip& strip = studio.strip;
  if (!strip_in_sight(studio)) return true;
  return !strip.loading && strip.loader.idle() && strip.fitter.idle() && !strip.newly_shown &&
         strip.asked_tiles == strip.tiles_revision &&
         std::ranges::equal(strip.tiles, studio.ui.strip.shapes, is_of);
}

std::optional<double> energy_change(const StripTile& tile) {
  if (!tile.fit || !tile.energy_before) return std::nullopt;
  return energy_without_missing(tile.fit->view).total() - *tile.energy_before;
}

void fill_strip_with_worst(Studio& studio) {
  const auto& rows = studio.collection.rows();
  std::vector<std::size_t> fitted;
  for (const std::size_t row : shown_rows(ShapeTable(rows, nullptr), {}, {{ShapeQuantity::energy}, true}))
    if (rows[row].fit && rows[row].id != studio.ui.shape) fitted.push_back(row);
  if (fitted.empty()) {
    fill_strip_at_random(studio);
    return;
  }
  if (fitted.size() > most_strip_shapes) fitted.resize(most_strip_shapes);
  StripChoice& choice = studio.ui.strip;
  choice.shapes.clear();
  for (const std::size_t row : fitted) choice.shapes.push_back(rows[row].id);
}

void fill_strip_at_random(Studio& studio) {
  StripChoice& choice = studio.ui.strip;
  std::vector<ShapeId> others;
  for (const ShapeRow& row : studio.collection.rows())
    if (row.id != studio.ui.shape) others.push_back(row.id);
  choice.shapes.clear();
  for (const std::size_t i : random_subset(others.size(), most_strip_shapes, ++choice.draws))
    choice.shapes.push_back(others[i]);
}

void add_to_strip(Studio& studio, ShapeId shape) {
  StripChoice& choice = studio.ui.strip;
  if (std::ranges::count(choice.shapes, shape) > 0) throw Error("the strip shows this shape already");
  if (choice.shapes.size() >= most_strip_shapes)
    throw Error("the strip is full: take one of its eight shapes out first");
  choice.shapes.push_back(shape);
}

void remove_from_strip(Studio& studio, ShapeId shape) {
  StripChoice& choice = studio.ui.strip;
  if (std::erase(choice.shapes, shape) == 0) throw Error("the strip does not show this shape");
  choice.emptied = choice.shapes.empty();
}

void clear_strip(Studio& studio) {
  studio.ui.strip.shapes.clear();
  studio.ui.strip.emptied = true;
}

}  // namespace archetype
