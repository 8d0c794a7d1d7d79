// Co-aligned clouds.
#include <cstdio>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/studio.h"

namespace archetype {
namespace {

template <CentreView view>
void show_view(Studio& studio, Arguments) {
  studio.ui.centre = view;
}
template <CentreView view>
bool shows_view(const Studio& studio) {
  return studio.ui.centre == view;
}

template <CloudColour colour>
void colour_by(Studio& studio, Arguments) {
  studio.ui.cloud.colour = colour;
}
template <CloudColour colour>
bool is_coloured_by(const Studio& studio) {
  return studio.ui.cloud.colour == colour;
}

void show_scope(Studio& studio, Arguments arguments) {
  const std::string what = text_argument(arguments, 0, "collection, selected or the name of a template");
  CloudChoice& cloud = studio.ui.cloud;
  if (what == "collection" || what == "selected") {
    cloud.scope = what == "collection" ? CloudScope::collection : CloudScope::selection;
    return;
  }
  // Not of the table of fits, which is there only once a panel has asked for it: a few milliseconds.
  if (studio.collection.open())
    for (const TemplateRecord& record : Project::open(studio.collection.path).templates())
      if (record.part_template.name == what) {
        cloud.scope = CloudScope::cluster;
        cloud.cluster = record.id;
        return;
      }
  throw Error("no shape is fitted by a template \"" + what +
              "\"; expected collection, selected or a template");
}

// The panes have another size then.
void toggle_pair(Studio& studio, Arguments) {
  studio.ui.cloud.pair = !studio.ui.cloud.pair;
  if (studio.ui.centre == CentreView::cloud) studio.ui.wanted_frame = true;
}

void blend_to(Studio& studio, Arguments arguments) {
  const double blend = number_argument(arguments, 0, "a number from 0 (rigid) to 1 (deformed)");
  if (blend < 0 || blend > 1) throw Error("expected a number from 0 (rigid) to 1 (deformed)");
  if (studio.ui.cloud.pair) toggle_pair(studio, {});
  studio.ui.cloud.blend = static_cast<float>(blend);
}

std::string needs_cloud(const Studio& studio) {
  return studio.ui.centre == CentreView::cloud && studio.cloud.content ? ""
                                                                       : "show the co-aligned points first";
}

void turn_cloud(Studio& studio, Arguments arguments) {
  const double frames = number_argument(arguments, 0, "how many frames");
  if (frames < 1 || frames > 100'000) throw Error("expected from 1 to 100000 frames");
  studio.cloud.turning = static_cast<int>(frames);
}

void report_cloud(Studio& studio, Arguments) {
  const CloudView& view = studio.cloud;
  const Sharpness& sharpness = view.content->sharpness;
  double whole = 0;
  for (std::size_t i = 0; i < view.shown; ++i)
    whole = std::max(whole, view.pictures[i].milliseconds_to_whole);
  char line[256];
  std::snprintf(line, sizeof line,
                "cloud: %zu shapes, %zu points of %zu, mean squared distance rigid %.5f deformed %.5f; all "
                "points %.0f ms after the last movement",
                view.content->shapes.size(), view.content->of.size(), view.content->samples,
                sharpness.mean_rigid(), sharpness.mean_deformed(), whole);
  studio.output.emplace_back(line);
}

}  // namespace

void add_cloud_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(),
                  {
                      {.name = "show-shape",
                       .title = "One shape",
                       .menu = "View",
                       .key = "Alt+1",
                       .run = show_view<CentreView::shape>,
                       .checked = shows_view<CentreView::shape>,
                       .separator = true},
                      {.name = "show-cloud",
                       .title = "Co-aligned points",
                       .menu = "View",
                       .key = "Alt+4",
                       .run = show_view<CentreView::cloud>,
                       .checked = shows_view<CentreView::cloud>},
                      {.name = "cloud-by-part",
                       .title = "Colour co-aligned points by part",
                       .run = colour_by<CloudColour::part>,
                       .checked = is_coloured_by<CloudColour::part>},
                      {.name = "cloud-by-shape",
                       .title = "Colour co-aligned points by shape",
                       .run = colour_by<CloudColour::shape>,
                       .checked = is_coloured_by<CloudColour::shape>},
                      {.name = "cloud-by-displacement",
                       .title = "Colour co-aligned points by how far the deformation moves them",
                       .run = colour_by<CloudColour::displacement>,
                       .checked = is_coloured_by<CloudColour::displacement>},
                      {.name = "cloud-pair",
                       .title = "Rigid beside deformed points",
                       .run = toggle_pair,
                       .checked = [](const Studio& s) { return s.ui.cloud.pair; }},
                      {.name = "cloud-boxes",
                       .title = "Mean boxes over the co-aligned points",
                       .run = [](Studio& s, Arguments) { s.ui.cloud.boxes = !s.ui.cloud.boxes; },
                       .checked = [](const Studio& s) { return s.ui.cloud.boxes; }},
                      {.name = "cloud-of",
                       .title = "Whose points are co-aligned",
                       .arguments = "collection|selected|TEMPLATE",
                       .run = show_scope},
                      {.name = "cloud-blend",
                       .title = "Co-aligned points between rigid and deformed",
                       .arguments = "0…1",
                       .run = blend_to},
                      {.name = "turn-cloud",
                       .title = "Turn the co-aligned points",
                       .arguments = "FRAMES",
                       .run = turn_cloud,
                       .why_not = needs_cloud},
                      {.name = "report-cloud",
                       .title = "Print how sharp the co-aligned points are",
                       .run = report_cloud,
                       .why_not = needs_cloud},
                  });
}

}  // namespace archetype
