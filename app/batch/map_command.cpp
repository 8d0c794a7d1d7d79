// archetype map PROJECT --from NAME --to NAME [--points FILE|-]
#include <iostream>
#include <iterator>

#include "app/batch/command.h"
#include "app/batch/json_output.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/io/file.h"
#include "core/io/text_cursor.h"
#include "core/session/map_points.h"

namespace archetype {

namespace {

struct Arguments {
  std::filesystem::path project;
  std::string from;
  std::string to;
  std::filesystem::path points = "-";
};

std::vector<Vec3> read_points(const std::filesystem::path& path) {
  const bool standard_input = path == "-";
  const std::string content =
      standard_input ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : read_file(path);
  const std::filesystem::path shown = standard_input ? "standard input" : path;
  TextCursor cursor(content, shown);
  std::vector<Vec3> points;
  while (cursor.next_line()) {
    Vec3& point = points.emplace_back();
    for (double& coordinate : point) coordinate = cursor.number();
    if (!cursor.at_line_end()) cursor.fail("expected x y z, found more: " + quote(cursor.rest_of_line()));
  }
  return points;
}

int run_map(const Arguments& arguments, const Invocation& invocation) {
  const Project project = Project::open(arguments.project);
  const std::vector<Vec3> points = read_points(arguments.points);
  const auto mapped = map_points(project, arguments.from, arguments.to, points);
  if (invocation.json) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& point : mapped) {
      if (point) {
        const Vec3& p = point->position;
        list.push_back({{"position", {p.x(), p.y(), p.z()}}, {"part", point->part}});
      } else {
        list.push_back(nullptr);
      }
    }
    print_json({{"from", arguments.from}, {"to", arguments.to}, {"points", list}});
    return exit_code::done;
  }
  std::string text;
  for (const auto& point : mapped) {
    if (point) {
      for (const double coordinate : point->position) text += number_text(coordinate) + ' ';
      text += std::to_string(point->part) + '\n';
    } else {
      text += "-1\n";
    }
  }
  std::cout << text;
  return exit_code::done;
}

}  // namespace

void add_map_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("map", "Find the points of a shape that correspond to another's");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("PROJECT", arguments->project, "Project file")->required();
  command->add_option("--from", arguments->from, "Name of the shape that the points are on")
      ->type_name("NAME")
      ->required();
  command->add_option("--to", arguments->to, "Name of the shape to find them on")
      ->type_name("NAME")
      ->required();
  command->add_option("--points", arguments->points, "File with x y z a line; - (default): standard input")
      ->type_name("FILE");
  add_common_options(*command, invocation);
  add_json_option(*command, invocation);
  command->callback([&invocation, arguments] {
    invocation.run = [&invocation, arguments] { return run_map(*arguments, invocation); };
  });
}

}  // namespace archetype
