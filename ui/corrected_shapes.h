// A shape whose correction was edited, undone or redone is fitted anew by itself, beside the window and as
// soon as nothing else writes to the project: clusters, clouds and plots show what was meant.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/io/project.h"

namespace archetype {

struct Studio;

// A fit that gave way to a corrected one. It comes back, with its status, when the correction is undone.
struct FormerFit {
  FitRecord record;
  std::optional<std::vector<std::int16_t>> labels;
};
using FormerFits = std::vector<FormerFit>;  // newest last

struct CorrectedShapes {
  std::filesystem::path project;            // that this is of
  std::shared_ptr<const Corrections> seen;  // as the document had them last
  std::vector<ShapeId> waiting;             // to be fitted anew, ascending
  std::shared_ptr<const FormerFits> former;
};

// Once a frame, after its panels.
void follow_corrections(Studio& studio);
bool corrections_settled(const Studio& studio);

}  // namespace archetype
