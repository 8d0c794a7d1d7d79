// archetype report PROJECT --out FILE.html [--labels DIR]
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"
#include "core/io/file.h"
#include "core/report/html_report.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::filesystem::path out;
  std::filesystem::path labels;  // empty: not asked for
};

int run_report(const Arguments& arguments, const Invocation& invocation) {
  const Project project = Project::open(arguments.project);
  ReportOptions options;
  options.labels = arguments.labels;
  options.threads = invocation.threads;
  std::optional<HtmlReport> report;
  {
    Progress progress;
    report = html_report(project, options, progress.control(invocation.stop));
  }
  if (!report) return exit_code::stopped;
  replace_file(arguments.out, report->page);
  if (invocation.json)
    print_json({{"shapes", report->shapes}, {"pictures", report->pictures}, {"bytes", report->page.size()}});
  else
    std::cout << "wrote " << arguments.out.string() << ": " << report->shapes << " shapes, "
              << report->pictures << " pictures" << std::endl;
  return exit_code::done;
}

}  // namespace

void add_report_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("report", "Write a page about a project that opens in a browser without a network");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("--out", arguments->out, "File to write")->type_name("FILE.html")->required();
  command->add_option("--labels", arguments->labels, "Folder of true labels, for the accuracy")
      ->type_name("DIR");
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_report(*arguments, invocation); };
  });
}

}  // namespace archetype
