// archetype plot PROJECT --plot NAME --out FILE.svg|.csv [--labels DIR] [--landmarks DIR] [--template T
// --part P]
#include <algorithm>
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/progress.h"
#include "core/base/error.h"
#include "core/report/figure_files.h"
#include "core/report/plot_catalog.h"
#include "core/session/ground_truth.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::string plot;
  std::filesystem::path out;
  GroundTruthFolders truth;
  std::string part_template;  // empty: the first
  std::string part;           // the same
};

// What the plot is made of, for as long as it takes.
struct Gathered {
  std::optional<FitTable> fits;
  std::optional<LearningRecord> learning;
  std::optional<LabellingEvaluation> labelling;
  std::optional<LandmarkEvaluation> landmarks;
  std::vector<SubsetMeasure> subsets;
  std::vector<StartMeasure> starts;
  bool stopped = false;
};

const std::filesystem::path& needed(const std::filesystem::path& folder, const char* option,
                                    const PlotEntry& entry) {
  if (folder.empty())
    throw Error(std::string(entry.name) + " needs ground truth: give its folder with " + option + " DIR");
  return folder;
}

std::string what_is_missing(const PlotEntry& entry, const Arguments& arguments) {
  switch (entry.need) {
    case PlotNeed::fits:
      return "it holds no fits; run `archetype fit` or `archetype learn` first";
    case PlotNeed::learning:
      return "nothing was learned in it; run `archetype learn` first";
    case PlotNeed::labels:
      return "no labelled shape of it has a label file in " + arguments.truth.labels.string();
    case PlotNeed::landmarks:
      return "no two labelled shapes of it have landmarks in " + arguments.truth.landmarks.string();
    case PlotNeed::subsets:
      return "it has no shapes or no template to learn from";
    case PlotNeed::starts:
      return "it has no shapes to learn from";
  }
  return "";
}

// What was said, or else what the project knows of.
GroundTruthFolders truth_for(const Project& project, const Arguments& arguments) {
  GroundTruthFolders truth = ground_truth_folders(project);
  if (!arguments.truth.labels.empty()) truth.labels = std::filesystem::absolute(arguments.truth.labels);
  if (!arguments.truth.landmarks.empty())
    truth.landmarks = std::filesystem::absolute(arguments.truth.landmarks);
  return truth;
}

// Whether it is the folder that was said, if one was.
bool is_as_said(const std::filesystem::path& folder, const std::filesystem::path& said) {
  std::error_code none;
  return said.empty() || folder == said || std::filesystem::equivalent(folder, said, none);
}

// What the project keeps of earlier measuring, unless that was against another truth than is said now.
template <typename Measure>
std::vector<Measure> kept(std::vector<Measure> measures, const GroundTruthFolders& said) {
  const bool answers = std::ranges::all_of(measures, [&](const Measure& each) {
    return is_as_said(each.truth.labels, said.labels) && is_as_said(each.truth.landmarks, said.landmarks);
  });
  return answers ? std::move(measures) : std::vector<Measure>();
}

Gathered gather(const Project& project, const PlotEntry& entry, const Arguments& arguments,
                const Invocation& invocation) {
  Progress progress;
  const JobControl control = progress.control(invocation.stop);
  Gathered found;
  if (entry.need == PlotNeed::fits) {
    found.fits = read_fit_table(project, control);
  } else if (entry.need == PlotNeed::learning) {
    found.learning = learning_record(project);
  } else if (entry.need == PlotNeed::labels) {
    found.labelling = evaluate_labelling(project, needed(arguments.truth.labels, "--labels", entry),
                                         invocation.threads, control);
  } else if (entry.need == PlotNeed::landmarks) {
    found.landmarks = evaluate_landmarks(project, needed(arguments.truth.landmarks, "--landmarks", entry),
                                         invocation.threads, control);
  } else if (project.shape_count() > 0 && entry.need == PlotNeed::subsets) {
    found.subsets = kept(stored_subset_measures(project), arguments.truth);
    const std::vector<PartTemplate> start = learning_start(project);
    if (found.subsets.empty() && !start.empty()) {
      auto measured =
          measure_subsets(project, start, subset_sizes(project.shape_count()), truth_for(project, arguments),
                          invocation.seed, invocation.threads, control);
      if (measured) found.subsets = std::move(*measured);
    }
  } else if (project.shape_count() > 0) {
    found.starts = kept(stored_start_measures(project), arguments.truth);
    if (found.starts.empty()) {
      auto measured = measure_suggested_starts(project, truth_for(project, arguments), invocation.seed,
                                               invocation.threads, control);
      if (measured) found.starts = std::move(*measured);
    }
  }
  found.stopped = control.cancelled();
  return found;
}

template <typename Named>
std::size_t index_of(const std::vector<Named>& all, const std::string& name, const char* what,
                     const std::string& (*name_of)(const Named&)) {
  if (name.empty()) return 0;
  const auto found = std::ranges::find(all, name, name_of);
  if (found == all.end())
    throw Error(std::string("there is no ") + what + " \"" + name + "\" that shapes are fitted by");
  return static_cast<std::size_t>(found - all.begin());
}

int run_plot(const Arguments& arguments, const Invocation& invocation) {
  const PlotEntry& entry = *find_plot(arguments.plot);
  Project project = Project::open(arguments.project);
  const Gathered found = gather(project, entry, arguments, invocation);
  if (found.stopped) return exit_code::stopped;
  if (found.labelling) print_refused(found.labelling->refused);
  if (found.landmarks) print_refused(found.landmarks->refused);
  PlotSources sources;
  sources.fits = found.fits ? &*found.fits : nullptr;
  sources.learning = found.learning ? &*found.learning : nullptr;
  sources.labelling = found.labelling ? &*found.labelling : nullptr;
  sources.landmarks = found.landmarks ? &*found.landmarks : nullptr;
  sources.subsets = found.subsets;
  sources.starts = found.starts;
  if (found.fits && entry.of_template) {
    sources.part_template = index_of<TemplateRecord>(
        found.fits->templates, arguments.part_template, "template",
        [](const TemplateRecord& record) -> const std::string& { return record.part_template.name; });
    if (entry.of_part && !found.fits->templates.empty())
      sources.part = index_of<TemplatePart>(
          found.fits->templates[sources.part_template].part_template.parts, arguments.part, "part",
          [](const TemplatePart& part) -> const std::string& { return part.name; });
  }
  if (!has_what_it_needs(entry, sources))
    throw FileError(arguments.project, what_is_missing(entry, arguments));
  write_figure(arguments.out, make_figure(entry, sources));
  // They took as long as several learnings: the next time they are there.
  if (entry.need == PlotNeed::subsets && stored_subset_measures(project) != found.subsets)
    store_subset_measures(project, found.subsets);
  if (entry.need == PlotNeed::starts && stored_start_measures(project) != found.starts)
    store_start_measures(project, found.starts);
  const bool refused = (found.labelling && !found.labelling->refused.empty()) ||
                       (found.landmarks && !found.landmarks->refused.empty());
  return refused ? exit_code::some_refused : exit_code::done;
}

std::vector<std::string> plot_names() {
  std::vector<std::string> names;
  for (const PlotEntry& entry : plot_catalog()) names.emplace_back(entry.name);
  return names;
}

std::string drawable_ending(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".svg" || ending == ".csv" ? "" : path + ": expected a name that ends with .svg or .csv";
}

}  // namespace

void add_plot_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("plot", "Draw a plot of a project as SVG, or write its values as CSV");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("--plot", arguments->plot, "Which one")
      ->type_name("NAME")
      ->required()
      ->check(CLI::IsMember(plot_names()));
  command->add_option("--out", arguments->out, "File to write; its ending, .svg or .csv, says as what")
      ->type_name("FILE")
      ->required()
      ->check(drawable_ending);
  command->add_option("--labels", arguments->truth.labels, "Folder with SHAPE.seg or SHAPE_labels.txt files")
      ->type_name("DIR");
  command->add_option("--landmarks", arguments->truth.landmarks, "Folder with SHAPE.vts files")
      ->type_name("DIR");
  command->add_option("--template", arguments->part_template, "Template of plots of one (default: the first)")
      ->type_name("NAME");
  command->add_option("--part", arguments->part, "Its part, for plots of one (default: the first)")
      ->type_name("NAME");
  add_common_options(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_plot(*arguments, invocation); };
  });
}

}  // namespace archetype
