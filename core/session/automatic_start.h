// A template to begin learning with, made of nothing but the shapes: the fully automatic mode of section 4.3.
#pragma once

#include <optional>

#include "core/base/job_control.h"
#include "core/fitting/fit_options.h"
#include "core/io/project.h"
#include "core/learning/learn_options.h"

namespace archetype {

// The key of the project's setting that says how far the choice has come.
inline constexpr std::string_view start_state_setting = "learn.start";

// Suggests templates (suggest_templates.h), learns a little from each on the shapes that would judge it, and
// takes the one whose learning ends with the least score (score_after_trial()). All of them are stored in the
// project then, and this one becomes its current template. What was suggested, and what came of each, is
// kept: a stopped or killed call goes on there, and ends with the same template, if options, seed and shapes
// are the same, and one that was done returns it again and changes nothing; `fresh` starts over. Nothing if
// cancelled. Throws PreconditionError without shapes.
//
// Differs from the paper, which learns from each of ten to the end and keeps the one with the best average
// energy over the whole collection: that would take several times as long, and what a start gains after its
// first rounds is little beside what parts the starts.
std::optional<PartTemplate> automatic_start(Project& project, const FitOptions& fit_options,
                                            const LearnOptions& options, std::uint64_t seed, bool fresh,
                                            unsigned threads, const JobControl& control);

}  // namespace archetype
