// A learning as a project would tell of it, made up.
#pragma once

#include "core/session/learn_templates.h"

namespace archetype::test {

// Begins with one template; every round re-estimates the first one and spawns another from the newest one
// until there are `templates`; shapes move there one after the other. Shapes have the ids from 1.
LearningRecord made_learning(std::size_t rounds, std::size_t templates, std::size_t shapes);

}  // namespace archetype::test
