// Parts that are kept each other's mirror image (TemplatePart::mirror).
#pragma once

#include <optional>

#include "core/model/part_template.h"

namespace archetype {

// The other part of its pair; nothing where it has none, or where a file gives the number to more than two.
std::optional<std::size_t> mirror_partner(const PartTemplate& part_template, std::size_t part);

int free_pair_number(const PartTemplate& part_template);

// From now on they are a pair; `follower` becomes the mirror image of `leader`. Both must be without a pair.
void link_mirror(PartTemplate& part_template, std::size_t leader, std::size_t follower, int axis);

// The partner gets the mirror image of the part's box, and its spreads, existence and must-exist. Name, label
// and features stay its own. Does nothing for a part without a partner.
void keep_in_step(PartTemplate& part_template, std::size_t leader);

// Where both parts of a pair have been moved on their own, each goes half the way to what the other wants.
void average_pairs(PartTemplate& part_template);

// Parts whose partner is no longer there are linked no more.
void drop_lone_links(PartTemplate& part_template);

}  // namespace archetype
