// Looking at a template that is not in the document, in the viewport and on the shape in view. It is no edit:
// the document and its history stay as they are until the template is taken. Whatever changes the document
// ends the look, so that nobody edits what they do not see.
#pragma once

#include <memory>
#include <string>

#include "core/model/part_template.h"

namespace archetype {

struct Studio;

struct TemplateLook {
  std::shared_ptr<const PartTemplate> part_template;
  std::string origin;  // where it comes from, for a person: "round 3"
};

// What the viewport shows and the shape in view is fitted to: the template that is looked at, or else the
// active one of the document; null if there is neither.
std::shared_ptr<const PartTemplate> shown_template(const Studio& studio);

void look_at(Studio& studio, const PartTemplate& part_template, std::string origin);
void stop_looking(Studio& studio);
// Makes it a template of the document, the active one, as one step that can be undone. Throws
// PreconditionError if none is looked at.
void take_look(Studio& studio);

// The strip above the view that says so, with the ways back; nothing while none is looked at.
void draw_look_strip(Studio& studio);

}  // namespace archetype
