// archetype export PROJECT --out DIR
#include <algorithm>
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"
#include "core/session/export_project.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::filesystem::path out;
  std::vector<std::string> only;
};

ExportOptions export_options(const Arguments& arguments, const Invocation& invocation) {
  const auto wanted = [&](const char* what) {
    return arguments.only.empty() || std::ranges::count(arguments.only, what) > 0;
  };
  ExportOptions options;
  options.labels = wanted("labels");
  options.templates = wanted("templates");
  options.fits = wanted("fits");
  options.coaligned = wanted("coaligned");
  options.boxes = wanted("boxes");
  options.seed = invocation.seed;
  options.threads = invocation.threads;
  return options;
}

int run_export(const Arguments& arguments, const Invocation& invocation) {
  const Project project = Project::open(arguments.project);
  ExportReport report;
  {
    Progress progress;
    report = export_project(project, arguments.out, export_options(arguments, invocation),
                            progress.control(invocation.stop));
  }
  if (invocation.json) {
    print_json({{"exported", report.shapes},
                {"not_fitted", report.without_fit},
                {"not_labelled", report.without_labels},
                {"cancelled", report.cancelled}});
  } else {
    std::cout << "exported " << report.shapes << ", not fitted " << report.without_fit << ", without labels "
              << report.without_labels << (report.cancelled ? ", stopped" : "") << std::endl;
  }
  return report.cancelled ? exit_code::stopped : exit_code::done;
}

}  // namespace

void add_export_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("export", "Write labels, templates, fits and co-aligned points as plain files");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("--out", arguments->out, "Folder to write to")->type_name("DIR")->required();
  command->add_option("--only", arguments->only, "Only some of it, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"labels", "templates", "fits", "coaligned", "boxes"}));
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_export(*arguments, invocation); };
  });
}

}  // namespace archetype
