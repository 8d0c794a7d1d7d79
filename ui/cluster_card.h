// What stands beside the members of a cluster: its template, or what the shapes without one have in common.
#pragma once

#include <imgui.h>

#include "core/session/shape_clusters.h"

namespace archetype {

struct Studio;

// At the cursor, `width` wide; its height.
float draw_cluster_card(Studio& studio, const ShapeCluster& cluster, float width);
// A height to begin with, before it was drawn.
float guessed_card_height(const Studio& studio);

// Brings the round of learning that the template came of into sight. Throws Error where it is of none.
void show_in_family_tree(Studio& studio, TemplateId part_template);

}  // namespace archetype
