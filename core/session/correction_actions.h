// The edits of what was said of single shapes: other yaws and templates, pinned labels, outliers.
//
// As those of actions.h: each starts from history.committed() and ends in a commit with a message, or in a
// preview while a stroke goes on. A commit that would change nothing makes no step. The shapes are not looked
// up: who calls has them in view.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/session/actions.h"

namespace archetype {

// A shape, and the name that messages call it by.
struct NamedShape {
  ShapeId id = 0;
  std::string name;
};

// From now on no other yaw (0 to 3 quarters), or template of another name, is tried on the shape; nothing or
// "" lets it free. Throws PreconditionError for a yaw that is none.
void pin_yaw(History& history, const NamedShape& shape, std::optional<int> quarters);
void pin_template(History& history, const NamedShape& shape, const std::string& template_name);
// Both at once: one of the alternatives that were shown.
void pin_yaw_and_template(History& history, const NamedShape& shape, int quarters,
                          const std::string& template_name);

void mark_shapes(History& history, std::span<const NamedShape> shapes, ShapeMark mark);

// The samples, of the sampling given (sampling_of()), belong to the part of this name from now on; "": to
// none. What was pinned of another sampling is void, and goes. Live stages are one stroke: each holds all
// samples of it so far.
void pin_samples(History& history, const NamedShape& shape, const ContentHash& sampling,
                 std::span<const std::uint32_t> samples, const std::string& part, Stage stage = Stage::done);
// They are free again.
void unpin_samples(History& history, const NamedShape& shape, const ContentHash& sampling,
                   std::span<const std::uint32_t> samples, Stage stage = Stage::done);
void unpin_all_samples(History& history, const NamedShape& shape);

void clear_corrections(History& history, std::span<const NamedShape> shapes);

// A template or part has another name from now on; "": as it was.
struct Renaming {
  std::string template_from = {};
  std::string template_to = {};
  std::string part_from = {};
  std::string part_to = {};
};
void rename_in_corrections(Document& document, const Renaming& renaming);

}  // namespace archetype
