#include "app/studio/run_studio.h"

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <thread>

#include "app/studio/desktop_window.h"
#include "app/studio/kept_settings.h"
#include "app/studio/resources.h"
#include "app/studio/timely_end.h"
#include "core/base/error.h"
#include "core/io/file.h"
#include "render/picture_file.h"
#include "ui/headless_window.h"
#include "ui/project_actions.h"
#include "ui/recovery.h"
#include "ui/script.h"

namespace archetype {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds grace_of_background_work{2};

void apply_settings(Settings& settings, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw Error("--set " + assignment + ": expected name=value");
    const std::string problem =
        set_setting(settings, assignment.substr(0, equals), assignment.substr(equals + 1));
    if (!problem.empty()) throw Error(std::string("--set ").append(assignment).append(": ").append(problem));
  }
}

// What --set changed was for this run; all else that was changed in it stays.
Settings settings_to_keep(Settings settings, const Settings& before, const StudioRequest& request) {
  for (const std::string& assignment : request.settings)
    copy_setting(settings, before, assignment.substr(0, assignment.find('=')));
  return settings;
}

// A script shall do the same each time, whatever was open last.
void open_first(Studio& studio, const StudioRequest& request) {
  if (!request.open.empty())
    open_path(studio, request.open);
  else if (request.script.empty() && !request.quit)
    open_last(studio);
  else
    open_seats(studio);
}

void print_output(Studio& studio) {
  for (const std::string& line : studio.output) std::printf("%s\n", line.c_str());
  if (!studio.output.empty()) std::fflush(stdout);
  studio.output.clear();
}

// F12 and --screenshot: taken of the frame that was just drawn.
void take_picture(Studio& studio) {
  if (!studio.wanted_picture) return;
  const fs::path path = *std::exchange(studio.wanted_picture, std::nullopt);
  Picture picture = picture_of_frame();
  studio.jobs.start("Picture " + path.filename().string(),
                    [&studio, path, picture = std::move(picture)](const JobControl&) -> Jobs::Apply {
                      write_png(path, picture);
                      return [&studio, path] {
                        say(studio, Severity::note, "Picture saved as " + path.string());
                      };
                    });
}

// The steps that a run goes through besides drawing frames.
struct Errand {
  std::optional<Script> script;
  fs::path screenshot;
  bool quit = false;
  int frames_to_settle = 3;  // the layout and what hovers come to rest

  // Once a frame; true when the program shall end.
  bool advance_frame(Studio& studio) {
    print_output(studio);
    if (script && !script->over()) {
      advance(*script, studio);
      frames_to_settle = 3;
      return studio.quit;
    }
    if (studio.quit) return true;
    if (screenshot.empty() && !quit) return false;
    if (!settled(studio)) {
      frames_to_settle = 3;
      return false;
    }
    if (frames_to_settle-- > 0) return false;
    if (screenshot.empty()) return quit;
    studio.wanted_picture = std::exchange(screenshot, {});
    frames_to_settle = 1;
    return false;
  }
  bool under_way() const { return (script && !script->over()) || !screenshot.empty() || quit; }
};

Errand errand_of(const StudioRequest& request, const Studio& studio) {
  Errand errand;
  if (!request.script.empty()) {
    errand.script.emplace();
    errand.script->name = request.script;
    errand.script->lines = parse_script(read_file(request.script, 1 << 20), request.script);
    check_script(studio, errand.script->lines, request.script);
  }
  errand.screenshot = request.screenshot;
  errand.quit = request.quit;
  return errand;
}

// A failed job, and nobody at the window to read of it.
int exit_status(const Studio& studio, bool unattended) {
  if (!unattended) return 0;
  int status = 0;
  for (const Message& message : studio.messages.list()) {
    if (message.severity != Severity::error) continue;
    std::fprintf(stderr, "archetype-studio: %s\n", message.text.c_str());
    status = 1;
  }
  return status;
}

template <typename Window>
void draw_frames(Window& window, Errand& errand, const std::function<void()>& after_frame) {
  Studio& studio = window.studio();
  for (;;) {
    window.frame();
    take_picture(studio);
    after_frame();
    studio.attended = !errand.under_way();
    if (errand.advance_frame(studio)) break;
    if constexpr (std::is_same_v<Window, DesktopWindow>) {
      if (window.take_close_wish()) request_close(studio);
    } else if (!settled(studio)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // leaves the processor to the jobs
    }
  }
}

template <typename Window>
int run_window(Window& window, const StudioRequest& request, const Settings& settings,
               const std::string& problem, const std::function<void()>& after_frame) {
  Studio& studio = window.studio();
  studio.settings = settings;
  if (!problem.empty()) studio.messages.warn(problem);
  Errand errand = errand_of(request, studio);
  if (!request.quit) begin_session(studio);
  // What was open when the program was killed is offered before anything else comes into view.
  if (!request.open.empty() || !request.script.empty() || studio.lost.empty()) open_first(studio, request);
  const bool unattended = request.quit;
  try {
    draw_frames(window, errand, after_frame);
  } catch (...) {
    save_now(studio);  // a script that fails in its tenth line leaves the work of nine
    throw;
  }
  if constexpr (std::is_same_v<Window, DesktopWindow>) window.hide();
  save_now(studio);
  print_output(studio);
  return exit_status(studio, unattended);
}

}  // namespace

int run_studio(const StudioRequest& request) {
  const Resources resources = find_resources();
  StudioOptions options;
  options.folders = user_folders();
  options.assets = resources.assets;
  options.shaders = resources.shaders;
  const fs::path settings_path = options.folders.config / "settings.json";
  const LoadedSettings loaded = load_settings(settings_path);
  Settings settings = loaded.settings;
  apply_settings(settings, request.settings);

  if (DesktopWindow::display_available()) {
    DesktopWindow window(settings.window_width, settings.window_height, options);
    Studio& studio = window.studio();
    if (request.quit) return run_window(window, request, settings, loaded.problem, [] {});
    KeptSettings kept(settings_path, loaded.settings);
    const auto to_keep = [&] { return settings_to_keep(studio.settings, loaded.settings, request); };
    const int status = run_window(window, request, settings, loaded.problem, [&] {
      kept.follow(to_keep());
      if (const std::string problem = kept.take_problem(); !problem.empty())
        say(studio, Severity::warning, problem);
    });
    kept.finish(to_keep());
    // All is saved, and the window gone from the screen: nobody shall wait for what still runs beside it.
    studio.session.reset();
    end_within(grace_of_background_work, status);
    return status;
  }
  if (!request.quit)
    throw Error("there is no display; without one, --quit is needed (with --screenshot or --script)");
  const auto scale = static_cast<float>(settings.ui_scale > 0 ? settings.ui_scale : 1.0);
  HeadlessWindow window(settings.window_width, settings.window_height, scale, options);
  return run_window(window, request, settings, loaded.problem, [] {});
}

}  // namespace archetype
