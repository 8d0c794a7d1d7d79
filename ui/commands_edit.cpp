// The menu Edit.
#include "ui/command_groups.h"
#include "ui/recovery.h"
#include "ui/selection.h"
#include "ui/studio.h"

namespace archetype {
namespace {

void undo_command(Studio& studio, Arguments) {
  const std::string message = studio.history.entries()[studio.history.position()].message;
  step_through_history(studio, [](History& history) { history.undo(); });
  studio.ui.status = "Undone: " + message;
}

void redo_command(Studio& studio, Arguments) {
  step_through_history(studio, [](History& history) { history.redo(); });
  studio.ui.status = "Redone: " + studio.history.entries()[studio.history.position()].message;
}

std::string needs_undo(const Studio& studio) {
  return studio.history.can_undo() || studio.history.has_preview() ? "" : "there is nothing to undo";
}

std::string needs_redo(const Studio& studio) {
  return studio.history.can_redo() ? "" : "there is nothing to redo";
}

// Esc: the nearest thing that is open or under way.
void cancel_command(Studio& studio, Arguments) {
  if (asks_to_close(studio)) {
    studio.ui.closing = {};
  } else if (offers_recovery(studio)) {
    close_recovery(studio);
  } else if (studio.ui.palette.open) {
    studio.ui.palette.open = false;
  } else if (studio.ui.browser.open) {
    studio.ui.browser.open = false;
  } else if (studio.ui.help || studio.ui.about) {
    studio.ui.help = studio.ui.about = false;
  } else if (studio.ui.show_suggestions) {
    studio.ui.show_suggestions = false;
  } else if (studio.ui.transform) {
    cancel_transform(studio);
    studio.ui.status = "Cancelled";
  } else if (studio.history.has_preview()) {
    studio.history.cancel_preview();
    studio.ui.cancel_drag = true;
    studio.ui.status = "Cancelled";
  } else if (studio.ui.points.tool != PointTool::none) {
    take_point_tool(studio, PointTool::none);
  } else if (studio.ui.centre == CentreView::inspect && studio.ui.inspect.painting) {
    studio.ui.inspect.painting = false;
  } else if (!selected_points(studio).empty()) {
    studio.ui.points.selected.clear();
  } else if (studio.ui.centre != CentreView::shape && studio.ui.selection.place) {
    studio.ui.selection.place.reset();
  } else if (studio.ui.centre != CentreView::shape && studio.ui.selection.part) {
    studio.ui.selection.part.reset();
  } else if (studio.ui.centre != CentreView::shape && !studio.ui.selection.shapes.empty()) {
    select_only(studio.ui.selection, {});
  } else if (studio.ui.look) {
    stop_looking(studio);
  } else {
    select_only(studio.ui, std::nullopt);
    studio.ui.selection.place.reset();
  }
}

}  // namespace

void add_edit_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(), {
                                      {.name = "undo",
                                       .title = "Undo",
                                       .menu = "Edit",
                                       .key = "Ctrl+Z",
                                       .run = undo_command,
                                       .why_not = needs_undo},
                                      {.name = "redo",
                                       .title = "Redo",
                                       .menu = "Edit",
                                       .key = "Ctrl+Shift+Z",
                                       .run = redo_command,
                                       .why_not = needs_redo},
                                      {.name = "cancel",
                                       .title = "Cancel, close or deselect",
                                       .menu = "Edit",
                                       .key = "Escape",
                                       .run = cancel_command,
                                       .separator = true},
                                  });
}

}  // namespace archetype
