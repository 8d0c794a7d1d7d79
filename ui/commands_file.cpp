// The menu File.
#include "core/base/error.h"
#include "core/generate/generate.h"
#include "ui/command_groups.h"
#include "ui/file_browser.h"
#include "ui/project_actions.h"
#include "ui/studio.h"

namespace archetype {
namespace {

void open_folder_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio, {.command = "open-folder", .title = "Open a folder of shapes", .folders_only = true});
  else
    open_folder(studio, text_argument(arguments, 0, "a folder"));
}

void open_project_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio, {.command = "open-project", .title = "Open a project", .ending = ".archetype"});
  else
    open_project(studio, text_argument(arguments, 0, "a project"));
}

void open_command(Studio& studio, Arguments arguments) {
  open_path(studio, text_argument(arguments, 0, "a folder, project, template or shape"));
}

void add_shapes_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio, {.command = "add-shapes", .title = "Add shapes of a file or folder", .shapes = true});
  else
    add_shapes(studio, {text_argument(arguments, 0, "a file or folder")});
}

// A copy of half an import or fit, with the rest going into the file that it was made of, helps nobody.
std::string needs_quiet_project(const Studio& studio) {
  if (!studio.collection.open() && studio.history.committed().templates.empty())
    return "open a folder or a project first, or make a template";
  return is_written(studio, studio.collection.path) ? "a job writes to the project; wait for it or stop it"
                                                    : "";
}

void save_as_command(Studio& studio, Arguments arguments) {
  if (arguments.empty())
    browse(studio, {.command = "save-as",
                    .title = "Save the project as",
                    .saving = true,
                    .replaces = false,
                    .ending = ".archetype"});
  else
    save_project_as(studio, text_argument(arguments, 0, "a path"));
}

// Everything is saved as it is made; who presses Ctrl+S wants to be sure, or wants the project elsewhere.
void save_command(Studio& studio, Arguments) {
  if (studio.collection.untitled) {
    save_as_command(studio, {});
    return;
  }
  save_soon(studio);
  say(studio, Severity::note, studio.collection.title + " is saved: every change is, as it is made");
}

void generate_command(Studio& studio, Arguments arguments) {
  const double count = arguments.size() > 1 ? number_argument(arguments, 1, "how many") : 60;
  if (count < 1 || count > 100'000) throw Error("expected from 1 to 100000 shapes");
  const std::string family = arguments.empty() ? "" : arguments[0];
  open_generated(studio, family, static_cast<std::size_t>(count));
}

template <const char* family>
void generate_family(Studio& studio, Arguments) {
  constexpr std::size_t count = 60;
  open_generated(studio, family, count);
}
constexpr char chairs[] = "chairs";
constexpr char lamps[] = "lamps";
constexpr char planes[] = "planes";
constexpr char tables[] = "tables";

void picture_command(Studio& studio, Arguments arguments) {
  if (!arguments.empty()) {
    studio.wanted_picture = text_argument(arguments, 0, "a file");
    return;
  }
  const std::filesystem::path folder = studio.options.folders.home;
  for (int number = 1; !studio.wanted_picture; ++number) {
    const auto path = folder / ("archetype-" + std::to_string(number) + ".png");
    if (!std::filesystem::exists(path)) studio.wanted_picture = path;
  }
}

}  // namespace

void add_file_commands(std::vector<Command>& commands) {
  commands.insert(commands.end(),
                  {
                      {.name = "open-folder",
                       .title = "Open folder…",
                       .menu = "File",
                       .key = "Ctrl+O",
                       .arguments = "[FOLDER]",
                       .run = open_folder_command},
                      {.name = "open-project",
                       .title = "Open project…",
                       .menu = "File",
                       .key = "Ctrl+Shift+O",
                       .arguments = "[FILE]",
                       .run = open_project_command},
                      {.name = "open", .title = "Open a path", .arguments = "PATH", .run = open_command},
                      {.name = "add-shapes",
                       .title = "Add shapes…",
                       .menu = "File",
                       .arguments = "[PATH]",
                       .run = add_shapes_command,
                       .why_not = needs_collection},
                      {.name = "open-seats",
                       .title = "Open the seats of Sweet Home 3D",
                       .menu = "File",
                       .run = [](Studio& s, Arguments) { open_seats(s); },
                       .separator = true},
                      {.name = "generate-chairs",
                       .title = "Generate chairs",
                       .menu = "File",
                       .run = generate_family<chairs>},
                      {.name = "generate-planes",
                       .title = "Generate planes",
                       .menu = "File",
                       .run = generate_family<planes>},
                      {.name = "generate-lamps",
                       .title = "Generate lamps",
                       .menu = "File",
                       .run = generate_family<lamps>},
                      {.name = "generate-tables",
                       .title = "Generate tables",
                       .menu = "File",
                       .run = generate_family<tables>},
                      {.name = "generate",
                       .title = "Generate a collection",
                       .arguments = "FAMILY [COUNT]",
                       .run = generate_command},
                      {.name = "save",
                       .title = "Save",
                       .menu = "File",
                       .key = "Ctrl+S",
                       .run = save_command,
                       .why_not = needs_collection,
                       .separator = true},
                      {.name = "save-as",
                       .title = "Save project as…",
                       .menu = "File",
                       .key = "Ctrl+Shift+S",
                       .arguments = "[FILE]",
                       .run = save_as_command,
                       .why_not = needs_quiet_project},
                      {.name = "picture",
                       .title = "Picture of the window",
                       .menu = "File",
                       .key = "F12",
                       .arguments = "[FILE.png]",
                       .run = picture_command,
                       .separator = true},
                  });
}

void add_quit_command(std::vector<Command>& commands) {
  commands.push_back({.name = "quit",
                      .title = "Quit",
                      .menu = "File",
                      .key = "Ctrl+Q",
                      .run = [](Studio& s, Arguments) { request_close(s); },
                      .separator = true,
                      .at_once = true});
}

}  // namespace archetype
