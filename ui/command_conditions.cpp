// What commands need before they can be used, and how they read their arguments.
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "ui/command_groups.h"
#include "ui/project_actions.h"
#include "ui/studio.h"

namespace archetype {

std::string needs_collection(const Studio& studio) {
  return studio.collection.open() ? "" : "open a folder or a project first";
}

std::string needs_any_shape(const Studio& studio) {
  if (std::string reason = needs_collection(studio); !reason.empty()) return reason;
  return studio.collection.rows().empty() ? "the collection has no shapes yet" : "";
}

std::string needs_shape(const Studio& studio) {
  return studio.shape.record ? "" : "click a shape in the collection first";
}

std::string needs_template(const Studio& studio) {
  return studio.history.current().active_template() ? "" : "make or load a template first";
}

std::string needs_part(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  return studio.ui.part ? "" : "select a part first";
}

std::string needs_fit(const Studio& studio) {
  if (std::string reason = needs_template(studio); !reason.empty()) return reason;
  if (std::string reason = needs_shape(studio); !reason.empty()) return reason;
  const Document& document = studio.history.committed();
  const bool current = studio.shape.fit && studio.shape.samples &&
                       studio.shape.fit->part_template == document.templates[document.active];
  return current ? "" : "wait for the fit of the shape in view";
}

std::string needs_free_shapes(const Studio& studio) {
  if (std::string reason = needs_any_shape(studio); !reason.empty()) return reason;
  return is_fitted(studio, studio.collection.path) ? "its shapes are being fitted; stop that job first" : "";
}

std::string needs_shapes_and_template(const Studio& studio) {
  if (std::string reason = needs_free_shapes(studio); !reason.empty()) return reason;
  const PartTemplate* active = studio.history.committed().active_template();
  return active && !active->parts.empty() ? "" : "make or load a template with at least one part first";
}

std::string needs_inspected(const Studio& studio) {
  if (std::string reason = needs_shape(studio); !reason.empty()) return reason;
  if (studio.ui.centre != CentreView::inspect) return "show the fit first (Alt+3)";
  return studio.inspection.main.shape ? "" : "wait until the shape is read";
}

double number_argument(Arguments arguments, std::size_t index, std::string_view what) {
  if (index >= arguments.size()) throw Error("expected " + std::string(what));
  const std::string& text = arguments[index];
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw Error("expected " + std::string(what) + ", not \"" + text + "\"");
  return value;
}

int yaw_argument(Arguments arguments, std::size_t index) {
  const double degrees = number_argument(arguments, index, "0, 90, 180 or 270");
  for (int quarters = 0; quarters < 4; ++quarters)
    if (degrees == quarters * 90) return quarters;
  throw Error("expected 0, 90, 180 or 270");
}

std::string text_argument(Arguments arguments, std::size_t first, std::string_view what) {
  std::string text;
  for (std::size_t i = first; i < arguments.size(); ++i) text += (i > first ? " " : "") + arguments[i];
  if (text.empty()) throw Error("expected " + std::string(what));
  return text;
}

}  // namespace archetype
