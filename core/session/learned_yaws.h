// Which way shapes were found to face when templates began to be learned from them. The project keeps it
// beside the learned templates, so that their fits do not turn shapes without reason (add_cost_of_turning()).
#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/io/project.h"

namespace archetype {

using KnownYaws = std::map<ShapeId, int>;  // quarter turns

// Empty unless these are the templates that the yaws were kept for. Shapes that were sampled anew since are
// left out, and so is whatever is damaged.
KnownYaws learned_yaws(const Project& project, const std::vector<TemplateId>& templates);
// yaws: one per shape.
void keep_learned_yaws(Project& project, const std::vector<TemplateId>& templates,
                       std::span<const ShapeId> shapes, std::span<const int> yaws);

}  // namespace archetype
