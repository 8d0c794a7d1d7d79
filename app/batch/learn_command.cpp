// archetype learn PROJECT [--template FILE]… [--iterations 10] [--fresh]
#include <iostream>
#include <map>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"
#include "app/batch/table.h"
#include "core/base/error.h"
#include "core/io/template_file.h"
#include "core/session/automatic_start.h"
#include "core/session/learn_templates.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::vector<std::filesystem::path> templates;
  LearnOptions options;
  bool fresh = false;
};

// A template that was learned, and how many shapes took it.
struct Learned {
  std::string name;
  std::size_t parts = 0;
  int born = 0;  // the round that its line was spawned in; 0: learning began with it
  std::size_t shapes = 0;
};

std::vector<Learned> learned_templates(const Project& project) {
  std::map<TemplateId, int> born;
  if (const auto record = learning_record(project)) {
    for (const LearningStep& step : record->steps)
      for (std::size_t t = 0; t < step.templates.size(); ++t)
        born[step.templates[t]] = record->lines[step.lines[t]].born;
  }
  std::map<TemplateId, std::size_t> shapes;
  for (const FitSummary& fit : project.fits()) ++shapes[fit.part_template];
  std::vector<Learned> learned;
  for (const TemplateRecord& record : project.templates())
    learned.push_back(
        {record.part_template.name, record.part_template.parts.size(), born[record.id], shapes[record.id]});
  return learned;
}

void print_report(const Project& project, const LearnReport& report, bool fresh,
                  const Invocation& invocation) {
  if (invocation.json) {
    auto rounds = nlohmann::ordered_json::array();
    for (const LearningStep& step : report.steps) {
      rounds.push_back({{"round", step.iteration},
                        {"templates", step.templates.size()},
                        {"energy_before", step.energy_before},
                        {"energy", step.energy}});
    }
    auto templates = nlohmann::ordered_json::array();
    for (const Learned& each : report.cancelled ? std::vector<Learned>{} : learned_templates(project)) {
      templates.push_back({{"name", each.name},
                           {"parts", each.parts},
                           {"born_in_round", each.born},
                           {"shapes", each.shapes}});
    }
    print_json({{"rounds", rounds},
                {"templates", templates},
                {"fitted", report.fit.fitted},
                {"kept", report.fit.kept},
                {"learned", report.learned},
                {"outliers", report.outliers},
                {"not_fitted_or_labelled", refused_json(report.fit.refused)},
                {"learning_seconds", report.learning_seconds},
                {"fitting_seconds", report.fitting_seconds},
                {"cancelled", report.cancelled}});
    return;
  }
  print_refused(report.fit.refused);
  std::vector<std::vector<std::string>> rows{{"round", "templates", "energy before", "energy"}};
  for (const LearningStep& step : report.steps) {
    rows.push_back({std::to_string(step.iteration), std::to_string(step.templates.size()),
                    fixed(step.energy_before, 4), fixed(step.energy, 4)});
  }
  print_table(std::cout, rows);
  if (report.cancelled) {
    std::cout << "\nstopped: the same command " << (fresh ? "without --fresh " : "") << "goes on from here"
              << std::endl;
    return;
  }
  rows = {{"template", "parts", "born in round", "shapes"}};
  for (const Learned& each : learned_templates(project)) {
    rows.push_back(
        {each.name, std::to_string(each.parts), std::to_string(each.born), std::to_string(each.shapes)});
  }
  std::cout << '\n';
  print_table(std::cout, rows);
  std::cout << "\nfitted " << report.fit.fitted << ", kept " << report.fit.kept << ", learned from "
            << report.learned << ", outliers " << report.outliers << ", refused " << report.fit.refused.size()
            << "\nlearning took " << fixed(report.learning_seconds, 1) << " s, fitting "
            << fixed(report.fitting_seconds, 1) << " s" << std::endl;
}

int run_learn(const Arguments& arguments, const Invocation& invocation) {
  std::vector<PartTemplate> templates;
  templates.reserve(arguments.templates.size());
  for (const std::filesystem::path& file : arguments.templates) templates.push_back(read_template(file));
  Project project = Project::open(arguments.project);
  if (project.shape_count() == 0)
    throw FileError(arguments.project, "has no shape yet; add some with `archetype import`");
  if (templates.empty()) templates = learning_start(project);
  LearnReport report;
  {
    Progress progress;
    if (templates.empty()) {
      const auto start = automatic_start(project, {}, arguments.options, invocation.seed, arguments.fresh,
                                         invocation.threads, progress.control(invocation.stop));
      if (start) templates.push_back(*start);
    }
    if (templates.empty()) {
      report.cancelled = true;
    } else {
      report = learn_templates(project, templates, {}, arguments.options, invocation.seed, arguments.fresh,
                               invocation.threads, progress.control(invocation.stop));
    }
  }
  print_report(project, report, arguments.fresh, invocation);
  if (report.cancelled) return exit_code::stopped;
  return report.fit.refused.empty() ? exit_code::done : exit_code::some_refused;
}

}  // namespace

void add_learn_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "learn", "Learn templates from the shapes of a project, and fit them to all of these");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command
      ->add_option("--template", arguments->templates,
                   "Template file to begin with; may be repeated. Default: the project's, or the best that "
                   "`init` finds")
      ->type_name("FILE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  command->add_option("--iterations", arguments->options.iterations, "Rounds, at most")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command->add_flag("--fresh", arguments->fresh, "Start over where a stopped run could be gone on with");
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_learn(*arguments, invocation); };
  });
}

}  // namespace archetype
