// The strip of other shapes.
#include <cstdio>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/shape_strip.h"
#include "ui/studio.h"

namespace archetype {
namespace {

// Pressed once more, its key leads back to the jobs.
void show_command(Studio& studio, Arguments) {
  const bool shown = strip_in_sight(studio);
  studio.settings.show_bottom = true;
  studio.ui.wanted_bottom_tab = shown ? BottomTab::jobs : BottomTab::strip;
}

void bring_into_sight(Studio& studio) {
  studio.settings.show_bottom = true;
  studio.ui.wanted_bottom_tab = BottomTab::strip;
}

std::string needs_others(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  return studio.collection.rows().size() < 2 ? "the collection has no other shape" : "";
}

std::string needs_strip(const Studio& studio) {
  return studio.ui.strip.shapes.empty() ? "the strip is empty" : "";
}

void worst_command(Studio& studio, Arguments) {
  fill_strip_with_worst(studio);
  bring_into_sight(studio);
}

void random_command(Studio& studio, Arguments) {
  fill_strip_at_random(studio);
  bring_into_sight(studio);
}

// The shape that is named, or the one in view.
ShapeId shape_argument(const Studio& studio, Arguments arguments) {
  if (arguments.empty()) {
    if (!studio.ui.shape) throw Error("show a shape first, or name one");
    return *studio.ui.shape;
  }
  const std::string name = text_argument(arguments, 0, "the name of a shape");
  for (const ShapeRow& row : studio.collection.rows())
    if (row.name == name) return row.id;
  throw Error("the collection has no shape \"" + name + "\"");
}

void add_command(Studio& studio, Arguments arguments) {
  add_to_strip(studio, shape_argument(studio, arguments));
  bring_into_sight(studio);
}

void remove_command(Studio& studio, Arguments arguments) {
  remove_from_strip(studio, shape_argument(studio, arguments));
}

void clear_command(Studio& studio, Arguments) {
  clear_strip(studio);
}

void report_command(Studio& studio, Arguments) {
  const LatencyMeter& latency = studio.strip.latency;
  const auto median = latency.percentile(0.5);
  if (!median) throw Error("the strip followed no edit yet; show it and drag a box first");
  char line[256];
  std::snprintf(
      line, sizeof line,
      "strip of %zu: %zu edits, median %.1f ms, 95th percentile %.1f ms, longest %.1f ms, last fits %.1f ms",
      studio.strip.tiles.size(), latency.milliseconds().size(), *median, *latency.percentile(0.95),
      *latency.percentile(1), studio.strip.fit_milliseconds);
  studio.output.emplace_back(line);
  for (const StripTile& tile : studio.strip.tiles) {
    if (!tile.fit) continue;
    std::snprintf(line, sizeof line, "  %s: energy %.6f change %+.6f", tile.shape->record.name.c_str(),
                  energy_without_missing(tile.fit->view).total(), energy_change(tile).value_or(0));
    studio.output.emplace_back(line);
  }
}

}  // namespace

void add_strip_commands(std::vector<Command>& commands) {
  commands.insert(
      commands.end(),
      {
          {.name = "strip",
           .title = "Strip of other shapes",
           .menu = "Shape",
           .key = "T",
           .run = show_command,
           .checked = strip_in_sight,
           .separator = true},
          {.name = "strip-worst",
           .title = "Strip: the shapes that fit worst",
           .menu = "Shape",
           .run = worst_command,
           .why_not = needs_others},
          {.name = "strip-random",
           .title = "Strip: random shapes",
           .menu = "Shape",
           .run = random_command,
           .why_not = needs_others},
          {.name = "strip-add",
           .title = "Strip: add the shape in view",
           .menu = "Shape",
           .key = "Ctrl+T",
           .arguments = "[NAME]",
           .run = add_command,
           .why_not = needs_any_shape},
          {.name = "strip-remove",
           .title = "Strip: take a shape out",
           .arguments = "[NAME]",
           .run = remove_command,
           .why_not = needs_strip},
          {.name = "strip-clear",
           .title = "Strip: take all shapes out",
           .menu = "Shape",
           .run = clear_command,
           .why_not = needs_strip},
          {.name = "report-strip", .title = "Print how fast the strip follows edits", .run = report_command},
      });
}

}  // namespace archetype
