// Which shapes are shown, and in which order.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/filter_panel.h"
#include "ui/order_menu.h"
#include "ui/studio.h"

namespace archetype {
namespace {

// Pressed once more, its key leads back to the jobs.
void show_command(Studio& studio, Arguments) {
  if (studio.settings.show_bottom && studio.ui.bottom_tab == BottomTab::filter)
    studio.ui.wanted_bottom_tab = BottomTab::jobs;
  else
    show_filter(studio);
}

void clear_command(Studio& studio, Arguments) {
  studio.ui.shown.filter = {};
}

std::string needs_filter(const Studio& studio) {
  return is_empty(studio.ui.shown.filter) ? "all shapes are shown" : "";
}

std::string needs_fitted_shape(const Studio& studio) {
  const std::optional<std::size_t> row =
      studio.ui.shape ? find_row(studio.collection, *studio.ui.shape) : std::nullopt;
  return row && studio.collection.rows()[*row].fit ? "" : "show a shape that is fitted first";
}

void name_command(Studio& studio, Arguments arguments) {
  studio.ui.shown.filter.name = arguments.empty() ? "" : text_argument(arguments, 0, "a part of names");
}

// The column that arguments from `quantity` on tell; a part's name comes last, at `rest`.
ShapeColumn column_argument(const Studio& studio, Arguments arguments, std::size_t rest) {
  if (arguments.empty()) throw Error("expected what to look at: energy, part-half-y, …");
  ShapeColumn column{.quantity = parse_quantity(arguments[0])};
  if (is_of_part(column.quantity)) column.part = text_argument(arguments, rest, "the name of a part");
  if (column.quantity == ShapeQuantity::similarity) {
    if (!studio.ui.shape) throw Error("show a shape first: the others are compared with it");
    column.shape = *studio.ui.shape;
  }
  return column;
}

void sort_command(Studio& studio, Arguments arguments) {
  const bool told = arguments.size() > 1 && (arguments[1] == "up" || arguments[1] == "down");
  const ShapeColumn column = column_argument(studio, arguments, told ? 2 : 1);
  studio.ui.shown.order = {column, told ? arguments[1] == "down" : descending_at_first(column)};
}

void similar_command(Studio& studio, Arguments) {
  studio.ui.shown.order = {{.quantity = ShapeQuantity::similarity, .shape = *studio.ui.shape}, false};
}

// "*" leaves an end open.
double end_argument(Arguments arguments, std::size_t index, double open) {
  return index < arguments.size() && arguments[index] == "*"
             ? open
             : number_argument(arguments, index, "a number or *");
}

void range_command(Studio& studio, Arguments arguments) {
  const ShapeColumn column = column_argument(studio, arguments, 3);
  const double low = end_argument(arguments, 1, -HUGE_VAL);
  const double high = end_argument(arguments, 2, HUGE_VAL);
  ShownShapes& shown = studio.ui.shown;
  set_range(shown.filter, column, low, high);
  if (std::ranges::find(shown.histograms, column, &ShownHistogram::column) != shown.histograms.end()) return;
  shown.histograms.push_back({column});
  shown.histograms_chosen = true;
}

void part_command(Studio& studio, Arguments arguments) {
  if (arguments.empty() || (arguments[0] != "has" && arguments[0] != "lacks"))
    throw Error("expected has or lacks, and the name of a part");
  const std::string part = text_argument(arguments, 1, "the name of a part");
  auto& conditions = studio.ui.shown.filter.parts;
  std::erase_if(conditions, [&](const PartCondition& condition) { return condition.part == part; });
  conditions.push_back({part, arguments[0] == "has"});
}

void status_command(Studio& studio, Arguments arguments) {
  const std::string wanted = text_argument(arguments, 0, "learned, fitted, outlier or none");
  ShapeFilter& filter = studio.ui.shown.filter;
  if (wanted == "none") {
    filter.hide_unfitted = !filter.hide_unfitted;
    return;
  }
  for (const FitStatus status : {FitStatus::fitted, FitStatus::learned, FitStatus::outlier}) {
    if (to_string(status) != wanted) continue;
    toggle_hidden(filter.hidden_statuses, status);
    return;
  }
  throw Error("expected learned, fitted, outlier or none, not \"" + wanted + "\"");
}

void report_command(Studio& studio, Arguments) {
  const std::size_t shown = shown_rows(studio).size();
  char line[128];
  std::snprintf(line, sizeof line, "%zu of %zu shapes shown, found in %.1f ms", shown,
                studio.collection.rows().size(), studio.ui.shown.milliseconds);
  studio.output.emplace_back(line);
}

}  // namespace

void add_filter_commands(std::vector<Command>& commands) {
  commands.insert(
      commands.end(),
      {
          {.name = "show-filter",
           .title = "Filter shapes",
           .menu = "View",
           .key = "Ctrl+F",
           .run = show_command,
           .checked =
               [](const Studio& s) { return s.settings.show_bottom && s.ui.bottom_tab == BottomTab::filter; },
           .separator = true},
          {.name = "clear-filter",
           .title = "Show all shapes",
           .menu = "View",
           .key = "Ctrl+Shift+F",
           .run = clear_command,
           .why_not = needs_filter},
          {.name = "sort-similar",
           .title = "Sort by similarity to the shape in view",
           .menu = "View",
           .run = similar_command,
           .why_not = needs_fitted_shape},
          {.name = "sort-by",
           .title = "Sort shapes",
           .arguments = "QUANTITY [up|down] [PART]",
           .run = sort_command,
           .why_not = needs_collection},
          {.name = "filter-name", .title = "Search for names", .arguments = "[TEXT]", .run = name_command},
          {.name = "filter-range",
           .title = "Keep a range",
           .arguments = "QUANTITY LOW HIGH [PART]",
           .run = range_command,
           .why_not = needs_collection},
          {.name = "filter-part",
           .title = "Keep shapes with or without a part",
           .arguments = "has|lacks PART",
           .run = part_command,
           .why_not = needs_collection},
          {.name = "filter-status",
           .title = "Hide or show shapes of a status",
           .arguments = "learned|fitted|outlier|none",
           .run = status_command,
           .why_not = needs_collection},
          {.name = "report-filter", .title = "Print how many shapes are shown", .run = report_command},
      });
}

}  // namespace archetype
