#include "ui/project_actions.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/generate/generate.h"
#include "core/io/read_shape.h"
#include "core/io/template_file.h"
#include "core/session/actions.h"
#include "core/session/fit_collection.h"
#include "ui/recovery.h"
#include "ui/selection.h"
#include "ui/studio.h"
#include "ui/widgets.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

void warn_of_refused(Studio& studio, const std::vector<RefusedInput>& refused) {
  for (const RefusedInput& input : refused) studio.messages.warn(input.path.string() + ": " + input.reason);
}

// What a job read of a project that is to be shown.
struct OpenedProject {
  fs::path path;
  std::string title;
  bool untitled = false;
  fs::path folder;  // of an untitled one
  CollectionRows content;
  Document document;
  bool document_is_stored = true;  // it is the one in the file
  std::vector<ShapeId> strip;
  std::vector<Credit> credits;
};

OpenedProject read_project(const fs::path& path, const std::string& title) {
  const Project project = Project::open(path);
  OpenedProject opened;
  opened.path = path;
  opened.title = title;
  opened.content = read_rows(project);
  opened.document = read_document(project);
  opened.strip = read_strip(project);
  if (const auto folder = project.setting("studio.folder")) opened.credits = read_credits(*folder);
  return opened;
}

// The session need not hold the document any more once the project does.
void hand_over_to_project(Studio& studio) {
  save_soon(studio);
  if (studio.session) studio.autosave.waiting.push_back({studio.session->document(), {}, true, {}});
}

void put_into_view(Studio& studio, OpenedProject opened) {
  save_soon(studio);
  const bool first = !studio.collection.open();
  // Templates that were made before anything was open come along.
  const bool brings_templates = opened.document.templates.empty() && first;
  if (brings_templates) {
    opened.document = studio.history.committed();
    opened.document_is_stored = opened.document.templates.empty();
  }
  studio.rows_reader.cancel();  // what it reads is of the project before
  studio.collection.path = std::move(opened.path);
  studio.collection.title = std::move(opened.title);
  studio.collection.untitled = opened.untitled;
  studio.collection.folder = std::move(opened.folder);
  studio.collection.content = std::move(opened.content);
  ++studio.collection.revision;
  studio.credits = std::move(opened.credits);
  studio.history = History(std::move(opened.document), "Open " + studio.collection.title);
  studio.autosave.edited_revision = studio.history.revision();
  studio.autosave.saved_revision.reset();
  if (opened.document_is_stored) studio.autosave.saved_revision = studio.history.committed_revision();
  studio.autosave.saved_strip = opened.strip;
  studio.ui.strip = {.shapes = std::move(opened.strip)};
  studio.autosave.opened = brings_templates ? Document{} : studio.history.committed();
  if (first) hand_over_to_project(studio);
  note_open_project(studio);
  select_only(studio.ui, std::nullopt);
  studio.ui.grid = {};
  forget_filter(studio.ui.shown);
  studio.ui.clusters = {};
  studio.opening.opened();
  studio.ui.selection = {};
  studio.ui.inspect = {};
  show_shape(studio, std::nullopt);
  if (!studio.collection.rows().empty()) show_shape(studio, studio.collection.rows()[0].id);
}

std::string summary(const ImportReport& report) {
  std::string text = plural(report.imported, "shape") + " read";
  if (report.unchanged > 0) text += ", " + std::to_string(report.unchanged) + " were there already";
  if (!report.refused.empty())
    text += ", " + std::to_string(report.refused.size()) + " refused (see messages)";
  return text + (report.cancelled ? "; stopped, open the folder again to go on" : "");
}

void start_import(Studio& studio, std::vector<fs::path> paths, bool fit_then = false) {
  const fs::path project_path = studio.collection.path;
  ImportOptions options;
  options.threads = static_cast<unsigned>(studio.settings.threads);
  const std::string title = "Import " + paths.front().filename().string();
  const JobId job = studio.jobs.start(title,
                                      [&studio, project_path, paths = std::move(paths), options,
                                       fit_then](const JobControl& control) -> Jobs::Apply {
                                        Project project = Project::open(project_path);
                                        ImportReport report = import_shapes(project, paths, options, control);
                                        return [&studio, project_path, fit_then, report = std::move(report)] {
                                          warn_of_refused(studio, report.refused);
                                          for (const std::string& warning : report.warnings)
                                            studio.messages.note(warning);
                                          if (report.imported > 0 || !report.refused.empty())
                                            say(studio, Severity::note, summary(report));
                                          const bool still_open = studio.collection.path == project_path;
                                          if (fit_then && !report.cancelled && still_open &&
                                              !is_fitted(studio, project_path) &&
                                              studio.history.committed().active_template())
                                            fit_all(studio);
                                        };
                                      });
  studio.writers.push_back({job, project_path, false});
}

fs::path seats_folder(const Studio& studio) {
  return studio.options.folders.cache / "collections" / "sweethome3d-seats";
}

// Prepares the folder (unpacks or generates it, say) beside the window, then shows its project and imports
// it. `starting_template`, if given, is what a project without a template begins with, fitted to all shapes.
void open_prepared_folder(Studio& studio, const fs::path& folder, const std::string& title,
                          const fs::path& starting_template, std::function<bool(const JobControl&)> prepare) {
  const fs::path path = untitled_project_path(studio.options.folders.data, folder);
  studio.jobs.start("Open " + title,
                    [&studio, path, folder, title, starting_template,
                     prepare = std::move(prepare)](const JobControl& control) -> Jobs::Apply {
                      if (prepare && !prepare(control)) return {};
                      fs::create_directories(path.parent_path());
                      Project::open_or_create(path).set_setting("studio.folder",
                                                                fs::absolute(folder).string());
                      OpenedProject opened = read_project(path, title);
                      opened.untitled = true;
                      opened.folder = folder;
                      const bool first_time = opened.document.templates.empty() && !starting_template.empty();
                      if (first_time) {
                        opened.document.templates.push_back(
                            std::make_shared<const PartTemplate>(read_template(starting_template)));
                        opened.document_is_stored = false;
                      }
                      return [&studio, folder, first_time, opened = std::move(opened)]() mutable {
                        put_into_view(studio, std::move(opened));
                        start_import(studio, {folder}, first_time);
                      };
                    });
}

}  // namespace

bool is_written(const Studio& studio, const fs::path& project) {
  return std::ranges::find(studio.writers, project, &ProjectWriter::project) != studio.writers.end();
}

bool is_fitted(const Studio& studio, const fs::path& project) {
  return std::ranges::any_of(
      studio.writers, [&](const ProjectWriter& writer) { return writer.fits && writer.project == project; });
}

void open_folder(Studio& studio, const fs::path& folder) {
  const fs::path absolute = fs::absolute(folder).lexically_normal();
  if (!fs::is_directory(absolute)) throw FileError(folder, "there is no such folder");
  const fs::path name = absolute.has_filename() ? absolute.filename() : absolute.parent_path().filename();
  remember_recent(studio.settings, absolute);
  open_prepared_folder(studio, absolute, name.string(), {}, {});
}

void open_project(Studio& studio, const fs::path& path) {
  const fs::path absolute = fs::absolute(path).lexically_normal();
  if (!fs::exists(absolute)) throw FileError(path, "there is no such project");
  remember_recent(studio.settings, absolute);
  const std::string title = absolute.stem().string();
  studio.opening.asked(OpeningMeter::Clock::now());
  studio.jobs.start("Open " + title, [&studio, absolute, title](const JobControl&) -> Jobs::Apply {
    return [&studio, opened = read_project(absolute, title)]() mutable {
      put_into_view(studio, std::move(opened));
    };
  });
}

void reopen_project(Studio& studio, const SessionRecord& record) {
  if (!record.folder.empty() && fs::is_directory(record.folder))
    open_prepared_folder(studio, record.folder, record.title, {}, {});
  else
    open_project(studio, record.project);
}

void open_last(Studio& studio) {
  const auto last = last_opened(studio.options.folders.data / "sessions");
  if (!last || last->folder == seats_folder(studio)) {
    open_seats(studio);
    return;
  }
  if (!last->folder.empty() && fs::is_directory(last->folder)) {
    open_prepared_folder(studio, last->folder, last->title, {}, {});
    return;
  }
  const auto instead = [&studio, title = last->title](const std::string& problem) {
    say(studio, Severity::warning, title + ", which was open last, cannot be opened: " + problem);
    open_seats(studio);
  };
  if (!fs::is_regular_file(last->project)) return instead("it is not there any more");
  studio.opening.asked(OpeningMeter::Clock::now());
  studio.jobs.start("Open " + last->title,
                    [&studio, last = *last, instead](const JobControl&) -> Jobs::Apply {
                      try {
                        return [&studio, opened = read_project(last.project, last.title)]() mutable {
                          put_into_view(studio, std::move(opened));
                        };
                      } catch (const std::exception& error) {
                        return [instead, problem = std::string(error.what())] { instead(problem); };
                      }
                    });
}

void add_shapes(Studio& studio, const std::vector<fs::path>& paths) {
  for (const fs::path& path : paths)
    if (!fs::exists(path)) throw FileError(path, "there is no such file or folder");
  if (!studio.collection.open()) throw Error("open a folder or a project first: shapes are added to it");
  start_import(studio, paths);
}

void open_path(Studio& studio, const fs::path& path) {
  if (fs::is_directory(path)) {
    open_folder(studio, path);
  } else if (path.extension() == ".archetype") {
    open_project(studio, path);
  } else if (path.extension() == ".json") {
    load_template(studio, path);
  } else if (has_shape_ending(path)) {
    if (studio.collection.open())
      add_shapes(studio, {path});
    else
      open_folder(studio, fs::absolute(path).parent_path());
  } else if (!fs::exists(path)) {
    throw FileError(path, "there is no such file or folder");
  } else {
    throw InputError(path, "", "expected a folder, a project (.archetype), a template (.json) or a shape");
  }
}

void save_project_as(Studio& studio, const fs::path& wanted) {
  fs::path path = fs::absolute(wanted).lexically_normal();
  if (path.extension() != ".archetype") path += ".archetype";
  if (fs::exists(path)) throw FileError(path, "exists already; choose another name");
  const fs::path from = studio.collection.path;
  const std::uint64_t revision = studio.history.committed_revision();
  studio.jobs.start("Save as " + path.filename().string(),
                    [&studio, from, path, revision, document = studio.history.committed(),
                     strip = studio.ui.strip.shapes](const JobControl& control) -> Jobs::Apply {
                      if (from.empty())
                        Project::create(path);
                      else
                        Project::open(from).copy_to(path);
                      // What is newest may not have come to the file that was copied.
                      if (const auto problem = save_document({path, document, false, strip}, control);
                          problem && !problem->empty())
                        throw Error(*problem);
                      return [&studio, from, path, revision] {
                        remember_recent(studio.settings, path);
                        if (studio.collection.path != from || is_written(studio, from)) {
                          say(studio, Severity::note, "A copy was saved as " + path.string());
                          return;
                        }
                        studio.collection.path = path;
                        studio.collection.title = path.stem().string();
                        studio.collection.untitled = false;
                        studio.collection.folder.clear();
                        studio.autosave.saved_revision =
                            revision;  // edits since then are still to come into the copy
                        if (from.empty()) hand_over_to_project(studio);
                        note_open_project(studio);
                        say(studio, Severity::note, "Saved as " + path.string());
                      };
                    });
}

void fit_all(Studio& studio) {
  const Document document = studio.history.committed();
  const PartTemplate part_template = *document.active_template();
  const fs::path path = studio.collection.path;
  const auto threads = static_cast<unsigned>(studio.settings.threads);
  const JobId job = studio.jobs.start(
      "Fit " + part_template.name + " to all shapes",
      [&studio, document, part_template, path, threads](const JobControl& control) -> Jobs::Apply {
        Project project = Project::open(path);
        store_corrections(project, document);
        const FitCollectionReport report = fit_collection(project, {part_template}, {}, threads, control);
        return [&studio, report] {
          warn_of_refused(studio, report.refused);
          std::string text = plural(report.fitted, "shape") + " fitted";
          if (report.kept > 0) text += ", " + std::to_string(report.kept) + " were up to date";
          if (!report.refused.empty()) text += ", " + std::to_string(report.refused.size()) + " could not be";
          say(studio, Severity::note, text + (report.cancelled ? "; stopped, fit again to go on" : ""));
        };
      });
  studio.writers.push_back({job, path, true});
}

void open_seats(Studio& studio) {
  const fs::path folder = seats_folder(studio);
  const fs::path furniture = studio.options.furniture;
  open_prepared_folder(
      studio, folder, "Seats of Sweet Home 3D", starting_template_path(studio, "chair"),
      [furniture, folder](const JobControl& control) { return extract_seats(furniture, folder, control); });
}

void open_generated(Studio& studio, const std::string& family, std::size_t count) {
  const FamilyNames names = family_names(family);  // throws for an unknown one
  GenerateOptions options;
  options.count = count;
  options.yaw = YawChoice::quarters;
  options.threads = static_cast<unsigned>(studio.settings.threads);
  // Another version of the program may draw other shapes: they get a folder of their own.
  const std::string description = describe_collection(names.name, options);
  const std::string version = hash_content(std::as_bytes(std::span(description))).to_hex().substr(0, 8);
  const fs::path folder = studio.options.folders.cache / "collections" /
                          (names.name + "-" + std::to_string(count) + "-" + version);
  const std::string one = names.name.substr(0, names.name.size() - 1);  // "chairs" -> "chair"
  // The labels lie beside them, under the same names.
  open_prepared_folder(studio, folder / "shapes", "Generated " + names.name,
                       starting_template_path(studio, one), [=](const JobControl& control) {
                         return !write_collection(names.name, options, folder, control).cancelled;
                       });
}

std::vector<std::string> starting_templates(const Studio& studio) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(studio.options.assets / "templates", none))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path starting_template_path(const Studio& studio, const std::string& name) {
  const fs::path path = studio.options.assets / "templates" / (fs::path(name).filename().string() + ".json");
  return fs::exists(path) ? path : fs::path();
}

void load_template(Studio& studio, const fs::path& path) {
  PartTemplate part_template = read_template(path);
  add_template(studio.history, std::move(part_template), "Load template " + path.filename().string());
  select_only(studio.ui, std::nullopt);
}

void save_template(Studio& studio, const fs::path& wanted) {
  fs::path path = wanted;
  if (path.extension() != ".json") path += ".json";
  write_template(path, *studio.history.committed().active_template());
  say(studio, Severity::note, "Template saved as " + path.string());
}

}  // namespace archetype
