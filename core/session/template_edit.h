// What the actions on parts share: how they start from the active template and end in a step.
#pragma once

#include <string>
#include <vector>

#include "core/session/actions.h"

namespace archetype {

// The active template of the committed document, to be changed and handed back. Throws PreconditionError.
PartTemplate active_copy(const History& history);

TemplatePart& part_of(PartTemplate& part_template, std::size_t part);

// The same in ascending order, each once; throws PreconditionError for none and for a part that is not there.
PartList checked_parts(const PartTemplate& part_template, PartList parts);

// "seat", or "3 parts".
std::string names_of(const PartTemplate& part_template, const PartList& parts);

// A live stage becomes a preview, a done one a step.
void put(History& history, PartTemplate part_template, Stage stage, const std::string& message);

// What a template file can hold of the numbers that are wanted; those that are not finite stay as before.
Vec3 storable(const Vec3& wanted, const Vec3& before, double least);
void set_box(TemplatePart& part, const Box& box);

// Throws Error where the template has no room for so many more.
void expect_room(const PartTemplate& part_template, std::size_t more);

// "leg 2" for "leg", "leg 3" for "leg 2": the first number that is free; the name itself where nobody has it.
std::string free_part_name(const PartTemplate& part_template, const std::string& name);

}  // namespace archetype
