// The edits of a template. The window changes the document in no other way.
//
// Each is a free function that starts from history.committed() and ends in a commit with a message, or, where
// it takes a Stage, in a preview while a drag goes on. All work on the active template and throw
// PreconditionError for a part or template that is not there, and Error for more parts than a template may
// have. Numbers are kept within what a template file can hold; those that are not finite change nothing. A
// commit that would change nothing makes no step.
#pragma once

#include <optional>
#include <span>
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
// What was learned, one template at least, takes the place of the templates `replaced`, ascending, or stands
// after all where these are none; the first of it becomes active.
void take_learned(History& history, std::vector<PartTemplate> learned, std::span<const std::size_t> replaced,
                  const std::string& message);

// Moves the active template by a number of places in the list, at most to its ends.
void move_active_template(History& history, int places);

// Parts, by their index; lists in any order. The functions that add some return where they now are.
//
// A part that is linked to its mirror image takes it along: its box, spreads, existence and must-exist are
// mirrored in the same step. Of two linked parts that are both edited the one named first leads.
using PartList = std::vector<std::size_t>;

// With a name that is free, and a label of its own.
std::size_t add_part(History& history, const Box& box, const std::string& name = "part");
// Beside the originals. Pairs of which both are copied are a pair again, the rest is without links.
PartList duplicate_parts(History& history, const PartList& parts);
// The mirror images across x = 0 (axis 0) or z = 0 (axis 2), linked to their originals. Throws Error where
// nothing can be mirrored: parts that are linked already or are their own mirror image are passed over.
PartList add_mirror_images(History& history, const PartList& parts, int axis);
// Two parts become a pair: the second the mirror image of the first. Earlier links of them end.
void link_parts(History& history, std::size_t leader, std::size_t follower, int axis);
void unlink_parts(History& history, const PartList& parts);
void remove_parts(History& history, const PartList& parts);
// One box, along the axes of the part named first, around two or more; it keeps that part's name, label and
// spreads. Where all have partners outside, these are merged too and linked. Returns its index.
std::size_t merge_parts(History& history, const PartList& parts);
// Two halves, cut across an axis of the box (0 to 2); a linked partner is cut too. Returns the halves.
PartList split_part(History& history, std::size_t part, int axis);
// Adds parts of this or another template at the end, with names of their own and the links among them.
PartList paste_parts(History& history, const std::vector<TemplatePart>& parts);

void rename_part(History& history, std::size_t part, const std::string& name);
void set_part_label(History& history, const PartList& parts, int label, Stage stage = Stage::done);  // >= 0
// One of part_colour_count, or -1 for that of its place in the list.
void set_part_colour(History& history, const PartList& parts, int colour);
void set_must_exist(History& history, const PartList& parts, bool must_exist);
// The mean box: what the gizmo and the typed numbers change. Half extents are kept above min_half_extent.
inline constexpr double min_half_extent = 0.005;  // normalised units
void set_part_box(History& history, std::size_t part, const Box& box, Stage stage = Stage::done);
struct PlacedPart {
  std::size_t part = 0;
  Box box;
};
void set_part_boxes(History& history, const std::vector<PlacedPart>& placed, Stage stage = Stage::done);
void set_position_stddev(History& history, const PartList& parts, const Vec3& stddev,
                         Stage stage = Stage::done);
void set_scale_stddev(History& history, const PartList& parts, const Vec3& stddev, Stage stage = Stage::done);
void set_existence(History& history, const PartList& parts, double existence,
                   Stage stage = Stage::done);  // (0, 1]

// The boxes of a fit become the mean boxes of the active template (parts that the shape lacks stay).
void adopt_fitted_boxes(History& history, const ShapeFit& fit);
// The features of the template's parts from the samples that a fit gave to each (parts with fewer than 5
// stay).
void learn_features(History& history, const ShapeSamples& samples, const ShapeFit& fit);
void forget_features(History& history);

}  // namespace archetype
