// Jobs that plots are made of: comparing with ground truth, and measuring how learning grows and what it
// begins with.
#include <cstdio>

#include "core/base/error.h"
#include "core/session/ground_truth.h"
#include "core/session/measure_starts.h"
#include "core/session/measure_subsets.h"
#include "ui/plot_sources.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seed = 1;  // that of the batch program

void require_folder(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_directory(folder, none)) throw FileError(folder, "there is no such folder");
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

// Where the results go, unless another project has come into view meanwhile.
Evaluations* evaluations_for(Studio& studio, const fs::path& project) {
  if (studio.collection.path != project) return nullptr;
  Evaluations& evaluations = studio.ui.plots.evaluations;
  if (evaluations.project != project) {
    evaluations = {};
    evaluations.project = project;
  }
  return &evaluations;
}

std::string refused_text(const std::vector<RefusedInput>& refused) {
  if (refused.empty()) return "";
  return "; " + plural(refused.size(), "file") + " refused, " + refused.front().path.string() + ": " +
         refused.front().reason;
}

}  // namespace

void evaluate_labels(Studio& studio, const fs::path& folder) {
  require_folder(folder);
  const fs::path path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  studio.jobs.start("Compare labels with " + folder.filename().string(),
                    [&studio, path, folder, threads](const JobControl& control) -> Jobs::Apply {
                      Project project = Project::open(path);
                      const std::uint64_t stamp = stamp_of(project.fits());
                      const auto found = std::make_shared<const LabellingEvaluation>(
                          evaluate_labelling(project, folder, threads, control));
                      if (found->cancelled) return {};
                      if (found->report.shapes.empty())
                        throw FileError(
                            folder, "no fitted shape has a label file here (SHAPE.seg or SHAPE_labels.txt)" +
                                        refused_text(found->refused));
                      remember_ground_truth(project, {.labels = folder, .landmarks = {}});
                      return [&studio, path, found, stamp] {
                        Evaluations* evaluations = evaluations_for(studio, path);
                        if (!evaluations) return;
                        evaluations->labelling = found;
                        evaluations->labelling_of = stamp;
                        say(studio, found->refused.empty() ? Severity::note : Severity::warning,
                            "Labels of " + plural(found->report.shapes.size(), "shape") +
                                " compared: " + percent(found->report.mean.own.by_area) +
                                " of the area right" + refused_text(found->refused));
                      };
                    });
}

void evaluate_marks(Studio& studio, const fs::path& folder) {
  require_folder(folder);
  const fs::path path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  studio.jobs.start("Compare landmarks with " + folder.filename().string(),
                    [&studio, path, folder, threads](const JobControl& control) -> Jobs::Apply {
                      Project project = Project::open(path);
                      const std::uint64_t stamp = stamp_of(project.fits());
                      const auto found = std::make_shared<const LandmarkEvaluation>(
                          evaluate_landmarks(project, folder, threads, control));
                      if (found->cancelled) return {};
                      if (found->all.by_diameter.count() == 0)
                        throw FileError(folder, "no two fitted shapes have landmarks here (SHAPE.vts)" +
                                                    refused_text(found->refused));
                      remember_ground_truth(project, {.labels = {}, .landmarks = folder});
                      return [&studio, path, found, stamp] {
                        Evaluations* evaluations = evaluations_for(studio, path);
                        if (!evaluations) return;
                        evaluations->landmarks = found;
                        evaluations->landmarks_of = stamp;
                        say(studio, found->refused.empty() ? Severity::note : Severity::warning,
                            "Landmarks of " + plural(found->shapes.size(), "shape") +
                                " compared: " + percent(found->all.by_diameter.within(10)) +
                                " within 0.05 of the diameter" + refused_text(found->refused));
                      };
                    });
}

void measure_sizes(Studio& studio) {
  const fs::path path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  const PartTemplate* active = studio.history.committed().active_template();
  const std::vector<PartTemplate> edited = active ? std::vector{*active} : std::vector<PartTemplate>{};
  studio.jobs.start("Measure learning by collection size",
                    [&studio, path, threads, edited](const JobControl& control) -> Jobs::Apply {
                      Project project = Project::open(path);
                      std::vector<PartTemplate> start = learning_start(project);
                      if (start.empty()) start = edited;
                      if (start.empty()) throw Error("there is no template to learn from");
                      const auto measures =
                          measure_subsets(project, start, subset_sizes(project.shape_count()),
                                          ground_truth_folders(project), seed, threads, control);
                      if (!measures) return {};
                      store_subset_measures(project, *measures);
                      return [&studio, path, count = measures->size()] {
                        if (studio.collection.path == path)
                          say(studio, Severity::note,
                              "Learning measured for " + plural(count, "size") + " of the collection");
                      };
                    });
}

void measure_starts(Studio& studio) {
  const fs::path path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  studio.jobs.start(
      "Learn from several starts", [&studio, path, threads](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(path);
        const auto measures =
            measure_suggested_starts(project, ground_truth_folders(project), seed, threads, control);
        if (!measures) return {};
        store_start_measures(project, *measures);
        return [&studio, path, count = measures->size()] {
          if (studio.collection.path == path)
            say(studio, Severity::note, "Learned from " + plural(count, "template") + " to begin with");
        };
      });
}

}  // namespace archetype
