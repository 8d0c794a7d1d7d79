#include "ui/centre_views.h"

#include <imgui.h>

#include <array>

#include "ui/clusters_view.h"
#include "ui/inspect_panels.h"
#include "ui/panels.h"
#include "ui/shape_map_view.h"
#include "ui/studio.h"
#include "ui/viewport.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

constexpr std::array views{
    CentreViewRow{CentreView::shape, "Shape", "show-shape", draw_tool_bar, draw_viewport},
    CentreViewRow{CentreView::clusters, "Clusters", "show-clusters", draw_clusters_tools, draw_clusters_view},
    CentreViewRow{CentreView::inspect, "Inspect", "show-inspect", draw_inspect_tools, draw_inspect_view,
                  draw_inspect_panel},
    CentreViewRow{CentreView::cloud, "Cloud", "show-cloud", draw_cloud_tools, draw_cloud},
    CentreViewRow{CentreView::map, "Map", "show-map", draw_map_tools, draw_map_view},
    CentreViewRow{CentreView::plots, "Plots", "show-plots", draw_plots_tools, draw_plots_view},
};

}  // namespace

std::span<const CentreViewRow> centre_views() {
  return views;
}

const CentreViewRow& centre_view(const Studio& studio) {
  for (const CentreViewRow& row : views)
    if (row.view == studio.ui.centre) return row;
  return views.front();
}

void draw_centre_tabs(Studio& studio) {
  if (views.size() < 2) return;
  separator_in_line(studio);
  for (const CentreViewRow& row : views) command_toggle(studio, row.command, row.name);
}

}  // namespace archetype
