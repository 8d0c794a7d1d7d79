// What stands in the middle of the window: the shape with its boxes, or a look at the whole collection. One
// row a view; the tabs in the menu bar and the frame follow the table.
#pragma once

#include <span>

namespace archetype {

struct Studio;

enum class CentreView { shape, clusters, inspect, cloud, map, plots };

struct CentreViewRow {
  CentreView view;
  const char* name;  // of its tab
  const char* command;
  void (*tools)(Studio&);  // what stands above it, in a line
  void (*draw)(Studio&);   // fills the window it is drawn in
  void (*side)(Studio&) =
      nullptr;  // what stands at the right; null: the template, its parts and the live fit
};

std::span<const CentreViewRow> centre_views();
const CentreViewRow& centre_view(const Studio& studio);  // the one that is shown
void draw_centre_tabs(Studio& studio);  // in the menu bar; nothing while there is one view only

}  // namespace archetype
