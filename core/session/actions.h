// The edits of a template. The window changes the document in no other way.
//
// Each is a free function that starts from history.committed() and ends in a commit with a message, or, where
// it takes a Stage, in a preview while a drag goes on. All work on the active template and throw
// PreconditionError for a part or template that is not there, and Error for more parts than a template may
// have. Numbers are kept within what a template file can hold; those that are not finite change nothing. A
// commit that would change nothing makes no step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/shape_fit.h"
#include "core/session/history.h"

namespace archetype {

enum class Stage { live, done };

// "chair", or "chair 2" where the document has a "chair" besides template number `except`; "template" for "".
std::string unique_template_name(const Document& document, const std::string& name, std::size_t except);

// Templates of the document. New ones become the active one; names are made unique by a number.
void add_template(History& history, PartTemplate part_template, const std::string& message);
void duplicate_active_template(History& history);
void remove_active_template(History& history);
void rename_active_template(History& history, const std::string& name);
void select_template(History& history, std::size_t index);
// What was learned, one template at least, takes the place of the active template, or of all; the first of it
// becomes active.
enum class LearnedFrom { active, all };
void take_learned(History& history, std::vector<PartTemplate> learned, LearnedFrom from,
                  const std::string& message);

// Parts. The functions that add one return its index.
std::size_t add_part(History& history, const Box& box);  // with its own name and a label of its own
std::size_t duplicate_part(History& history, std::size_t part);
// Mirrored at the plane x = 0, the plane of symmetry of most things that stand upright.
std::size_t mirror_part(History& history, std::size_t part);
void remove_part(History& history, std::size_t part);

void rename_part(History& history, std::size_t part, const std::string& name);
void set_part_label(History& history, std::size_t part, int label, Stage stage = Stage::done);  // >= 0
void set_must_exist(History& history, std::size_t part, bool must_exist);
// The mean box: what the gizmo and the typed numbers change. Half extents are kept above min_half_extent.
inline constexpr double min_half_extent = 0.005;  // normalised units
void set_part_box(History& history, std::size_t part, const Box& box, Stage stage = Stage::done);
void set_position_stddev(History& history, std::size_t part, const Vec3& stddev, Stage stage = Stage::done);
void set_scale_stddev(History& history, std::size_t part, const Vec3& stddev, Stage stage = Stage::done);
void set_existence(History& history, std::size_t part, double existence,
                   Stage stage = Stage::done);  // (0, 1]

// The boxes of a fit become the mean boxes of the active template (parts that the shape lacks stay).
void adopt_fitted_boxes(History& history, const ShapeFit& fit);
// The features of the template's parts from the samples that a fit gave to each (parts with fewer than 5
// stay).
void learn_features(History& history, const ShapeSamples& samples, const ShapeFit& fit);
void forget_features(History& history);

}  // namespace archetype
