// What a person edits in the window: plain, comparable data, undone and redone as a whole.
//
// Bulk results (samples, fits, thumbnails) live in the project file; selection, camera and open panels are
// UiState. Neither is part of the document.
#pragma once

#include <memory>
#include <vector>

#include "core/io/project.h"
#include "core/model/part_template.h"

namespace archetype {

// Templates are shared between snapshots, so that a history of hundreds of edits costs one changed template
// each.
struct Document {
  std::vector<std::shared_ptr<const PartTemplate>> templates;  // never null
  std::size_t active = 0;  // the template being edited and fitted; 0 while there is none
  std::shared_ptr<const Corrections> corrections = {};  // of single shapes and their fits; null: none

  // Null while there is no template.
  const PartTemplate* active_template() const {
    return active < templates.size() ? templates[active].get() : nullptr;
  }
};

// The correction of a shape; null where there is none.
const ShapeCorrection* correction_of(const Document& document, ShapeId shape);

// By value of the templates and corrections, not by address.
bool operator==(const Document& a, const Document& b);

}  // namespace archetype
