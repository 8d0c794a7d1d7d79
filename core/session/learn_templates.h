// Learns templates from the shapes of a project (section 4.2 and figure 2).
#pragma once

#include "core/learning/learn_options.h"
#include "core/session/fit_collection.h"

namespace archetype {

// A template and all that it was re-estimated to, round after round, are one line. Whatever is spawned begins
// another.
struct LearningLine {
  std::optional<std::size_t> parent;  // the line that it was spawned by; nothing: learning began with it
  int born = 0;                       // the round that it was spawned in, 0: none
};

// What one round left.
struct LearningStep {
  int iteration = 0;         // from 1
  double energy_before = 0;  // as in LearningRound
  double energy = 0;
  std::vector<TemplateId> templates;  // those of rounds that are over stay in the project
  std::vector<std::size_t> lines;     // by template: an index into LearningRecord::lines
  std::vector<std::size_t> taken;     // by judging shape: an index into `templates`
};

struct LearnReport {
  std::vector<LearningStep> steps;  // also those of a stopped run that this one went on from
  FitCollectionReport fit;          // of the learned templates to the whole collection
  std::size_t learned = 0;          // shapes that the templates were learned from, or could have been
  std::size_t outliers = 0;         // shapes that no template explains
  double learning_seconds = 0;      // of this call, until the templates were there
  double fitting_seconds = 0;       // of this call, for the whole collection
  bool cancelled = false;
};

// The key of the project's setting that says how far learning has come.
inline constexpr std::string_view learn_state_setting = "learn.state";

// What a project tells of the learning that goes on in it, or that was done or stopped last.
struct LearningRecord {
  std::vector<PartTemplate> start;        // what it began with: the first lines, in this order
  std::vector<ShapeId> judging;           // the shapes that judge every round
  std::vector<LearningLine> lines;        // parents before their children
  std::vector<LearningStep> steps;        // the rounds that are whole
  std::vector<TemplateRecord> templates;  // those of all steps, ordered by id
  bool settled = false;                   // the last round kept nothing new
};
// Nothing where nothing was learned, or by a program that kept less. Throws FileError. A few milliseconds.
std::optional<LearningRecord> learning_record(const Project& project);

// What to learn from where nothing else is said: the current templates, or, where these were learned, what
// that learning began with. Empty for a project without templates.
std::vector<PartTemplate> learning_start(const Project& project);

// Of everything that decides what is learned in a round: templates, options, seed, and the shapes with their
// samples and corrections. Not of options.iterations, which says how many there are at most: ten rounds are
// gone on with where twenty are wanted, and begun anew where five are.
ContentHash learn_request(const Project& project, const std::vector<PartTemplate>& initial,
                          const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed);

// Whether no round follows on those of the record: the last kept nothing new, or there were enough.
bool is_over(const LearningRecord& record, const LearnOptions& options);

// Whether the learning that the project tells of is of these options and this seed, of the shapes as they are
// and of what is corrected of them now, and has no more rounds than are wanted: learn_templates() goes on
// with it from what it began with. False where nothing was learned. About 10 ms for 10,000 shapes.
bool can_go_on(const Project& project, const FitOptions& fit_options, const LearnOptions& options,
               std::uint64_t seed);

// The mean start_score() that a few rounds of learning from one template end with, on the shapes that would
// judge it. It is not divided in these: of two starts the one that happens to divide in the second round, not
// in the third, would seem the better one. The project is not changed. Nothing if cancelled. Throws
// PreconditionError without shapes.
std::optional<double> score_after_trial(const Project& project, const PartTemplate& start,
                                        const FitOptions& fit_options, const LearnOptions& options,
                                        std::uint64_t seed, unsigned threads, const JobControl& control);

// Refines and spawns templates round by round until a round keeps nothing new or there were
// options.iterations, then fits what was learned to
// every shape and labels it. A round is one transaction: its templates become the current ones and remember
// their parents and the round; who stops before the first is through changes nothing. A stopped run goes on
// there, and ends with the same bytes as one that was not stopped, if templates, options, seed, shapes and
// what was corrected of them are the same; `fresh` starts over. Where no round is left, the templates of the
// last one become the current ones again. Shapes marked as outliers take no part, those
// marked to be learned from do in every round (beyond options.sample_size: as many of them, drawn anew);
// pinned yaws, templates and labels hold (learning_round.h). Works on options.sample_size random shapes that
// judge each round, and as many that change; holds only these. Throws PreconditionError without templates or
// shapes, Error where all shapes are marked as outliers.
LearnReport learn_templates(Project& project, const std::vector<PartTemplate>& initial,
                            const FitOptions& fit_options, const LearnOptions& options, std::uint64_t seed,
                            bool fresh, unsigned threads, const JobControl& control);

}  // namespace archetype
