// archetype generate FAMILY --count N --out DIR
#include "core/generate/generate.h"

#include <algorithm>
#include <iostream>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "app/batch/progress.h"

namespace archetype {

namespace {

struct Arguments {
  std::string family;
  std::filesystem::path out;
  GenerateOptions options;
  std::string yaw = "none";
  std::vector<std::string> ups{"y"};
  std::string format = "off";
};

GenerateOptions generate_options(const Arguments& arguments, const Invocation& invocation) {
  GenerateOptions options = arguments.options;
  options.seed = invocation.seed;
  options.threads = invocation.threads;
  if (arguments.yaw != "none") options.yaw = arguments.yaw == "any" ? YawChoice::any : YawChoice::quarters;
  options.ups.clear();
  for (const std::string& up : arguments.ups) options.ups.push_back(parse_up_axis(up).value());
  options.ending = arguments.format == "obj" ? ShapeEnding::obj : ShapeEnding::off;
  return options;
}

int run_generate(const Arguments& arguments, const Invocation& invocation) {
  GenerateReport report;
  {
    Progress progress;
    report = write_collection(arguments.family, generate_options(arguments, invocation), arguments.out,
                              progress.control(invocation.stop));
  }
  if (invocation.json) {
    print_json({{"written", report.written}, {"cancelled", report.cancelled}});
  } else {
    std::cout << "wrote " << report.written << " " << arguments.family
              << (report.cancelled ? ", stopped: the same command goes on from here" : "") << std::endl;
  }
  return report.cancelled ? exit_code::stopped : exit_code::done;
}

// Which styles there are is known once the family is.
void check_styles(const Arguments& arguments) {
  const std::vector<std::string> known = family_names(arguments.family).styles;
  for (const std::string& style : arguments.options.styles) {
    if (std::ranges::count(known, style) > 0) continue;
    std::string list;
    for (const std::string& each : known) list.append(list.empty() ? "" : ", ").append(each);
    const std::string of_family = " is no style of " + arguments.family + "; there are ";
    throw CLI::ValidationError("--style", std::string(style).append(of_family).append(list));
  }
}

void add_fault_options(CLI::App& command, SoupFaults& faults) {
  const auto add = [&command](const char* name, double& value, const char* what) {
    command.add_option(name, value, what)
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str()
        ->group("Soup faults");
  };
  add("--flipped", faults.flipped, "Share of faces that are turned inside out");
  add("--duplicate", faults.duplicate, "Share of faces that are there twice");
  add("--intersecting", faults.intersecting, "Share of faces that another one stands across");
  add("--non-manifold", faults.non_manifold, "Share of faces with a third face on an edge");
  add("--degenerate", faults.degenerate, "Share of faces that are followed by one without area");
}

void add_variation_options(CLI::App& command, Arguments& arguments) {
  GenerateOptions& options = arguments.options;
  command.add_option("--style", options.styles, "Only shapes of this style; may be repeated. Default: all")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  command
      .add_option("--noise", options.noise, "Standard deviation of coordinates, over the shape's diagonal")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command
      .add_option("--missing-parts", options.missing_parts,
                  "Probability that the parts of a label are left out")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--yaw", arguments.yaw, "How shapes are turned about up")
      ->check(CLI::IsMember({"none", "quarters", "any"}))
      ->capture_default_str();
  command.add_option("--scale-spread", options.scale_spread, "Sizes differ by a factor of up to exp of this")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command.add_option("--offset", options.offset, "Shapes are moved by up to this many diagonals")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_option("--up", arguments.ups, "Axis that points up; repeated: one of them for each shape")
      ->check(CLI::IsMember({"y", "z", "x", "-y", "-z", "-x"}))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->capture_default_str();
  command.add_flag("--triangles", options.triangles, "Cut all faces into triangles");
  command.add_option("--format", arguments.format, "Format of the shapes")
      ->check(CLI::IsMember({"off", "obj"}))
      ->capture_default_str();
}

}  // namespace

void add_generate_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("generate", "Write a sample collection with ground truth");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("FAMILY", arguments->family, "What to make")
      ->check(CLI::IsMember(families()))
      ->required();
  command->add_option("--count", arguments->options.count, "Number of shapes")
      ->check(CLI::Range(1, 1'000'000))
      ->required();
  command->add_option("--out", arguments->out, "Folder to write to")->type_name("DIR")->required();
  add_variation_options(*command, *arguments);
  add_fault_options(*command, arguments->options.faults);
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    check_styles(*arguments);
    invocation.run = [&invocation, arguments] { return run_generate(*arguments, invocation); };
  });
}

}  // namespace archetype
