// The command table, scripts and keys.
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/base/error.h"
#include "tests/ui/test_window.h"
#include "ui/script.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

std::string problem_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

void run_script(TestWindow& window, const std::string& text) {
  Script script{"test.txt", parse_script(text, "test.txt"), 0};
  check_script(window.studio(), script.lines, script.name);
  while (!script.over()) {
    advance(script, window.studio());
    window.frames();
  }
  window.settle();
}

}  // namespace

TEST_CASE("Names and keys of commands are unique, titles are there, keys can be parsed") {
  std::set<std::string_view> names;
  std::set<std::string> keys;
  for (const Command& command : all_commands()) {
    CAPTURE(command.name);
    CHECK(names.insert(command.name).second);
    CHECK((command.run != nullptr));
    CHECK_FALSE(command.title.empty());
    CHECK(std::all_of(command.name.begin(), command.name.end(),
                      [](char c) { return (c >= 'a' && c <= 'z') || c == '-' || (c >= '0' && c <= '9'); }));
    if (command.key.empty()) continue;
    CHECK(keys.insert(std::string(command.key)).second);
    const auto chord = parse_chord(command.key);
    REQUIRE(chord.has_value());
    CHECK(to_string(*chord) == command.key);
  }
}

TEST_CASE("A key that runs a command is not one to walk among the widgets with") {
  for (const ImGuiKey key : {ImGuiKey_Home, ImGuiKey_Escape}) {
    TestWindow window;
    window.make_template();
    window.click("tab:Learning");
    window.click("viewport");
    window.studio().pressed_keys.push_back(*parse_chord(key == ImGuiKey_Home ? "Home" : "Escape"));
    window.field_key(key);
    CHECK(ImGui::GetCurrentContext()->NavDisableHighlight);
    CHECK_FALSE(ImGui::GetCurrentContext()->NavDisableMouseHover);
  }
}

TEST_CASE("The panel below is high for what needs it, and gives the room back for other tabs") {
  TestWindow window;
  const auto top = [&] {
    window.frames(3);
    return std::ranges::find(window.studio().targets, "tab:Jobs", &Target::name)->low_y;
  };
  const float low = top();
  window.key("L");
  const float high = top();
  CHECK(high < low - 100);
  window.click("tab:Jobs");
  CHECK(top() == low);
  window.click("tab:Filter");
  CHECK(top() < low - 40);
  window.drag("splitter:bottom", 0, -60);
  window.click("tab:Jobs");
  CHECK(top() < low - 90);
}

TEST_CASE("Every command without arguments runs or says why not, on an empty window and on a template") {
  for (const bool with_template : {false, true}) {
    TestWindow window;
    if (with_template) {
      window.make_template();
      window.studio().ui.part = 0;
    }
    for (const Command& command : all_commands()) {
      const bool starts_long_work = command.name.starts_with("generate") || command.name == "open-seats";
      const bool needs_arguments = !command.arguments.empty() && command.arguments[0] != '[';
      if (starts_long_work || needs_arguments || command.name == "quit") continue;
      CAPTURE(command.name);
      const std::string reason = why_not(window.studio(), command);
      const std::uint64_t messages = window.studio().messages.count();
      const bool ran = run_command(window.studio(), command.name);
      if (!reason.empty()) CHECK_FALSE(ran);
      if (!ran) CHECK(window.studio().messages.count() > messages);
      window.frames(2);
      window.studio().wanted_picture.reset();
    }
  }
}

TEST_CASE("The line at the bottom tells of every edit, and no longer of what was before it") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  window.settle();
  const std::string& status = window.studio().ui.status;
  REQUIRE(run_command(window.studio(), "select-part", std::vector<std::string>{"seat"}));
  window.key("Ctrl+C");
  CHECK(status == "Copied seat");
  window.key("Ctrl+V");
  window.frames(2);
  CHECK(status == "Done: Paste seat 2");
  window.key("Ctrl+Z");
  window.frames(2);
  CHECK(status == "Undone: Paste seat 2");
  window.key("Ctrl+Z");
  window.frames(2);
  CHECK(status != "Undone: Paste seat 2");
  CHECK(status.starts_with("Undone: "));
  window.key("Ctrl+Shift+Z");
  window.frames(2);
  CHECK(status.starts_with("Redone: "));
  REQUIRE(run_command(window.studio(), "add-part"));
  window.frames(2);
  CHECK(status == "Done: Add part");
}

TEST_CASE("Keys can be set by the user") {
  TestWindow window;
  window.studio().settings.keys["theme-light"] = "Ctrl+L";
  window.studio().settings.keys["keys"] = "";
  window.key("Ctrl+L");
  CHECK(window.studio().settings.theme == "light");
  window.key("F1");
  CHECK_FALSE(window.studio().ui.help);
}

TEST_CASE("Chords are read as people write them") {
  CHECK(parse_chord("ctrl+shift+z") == KeyChord{"Z", true, true, false});
  CHECK(parse_chord("Ctrl++") == KeyChord{"+", true, false, false});
  CHECK(parse_chord("f12") == KeyChord{"F12", false, false, false});
  CHECK_FALSE(parse_chord(""));
  CHECK_FALSE(parse_chord("Ctrl+"));
  CHECK_FALSE(parse_chord("Hyper+A"));
  CHECK_FALSE(parse_chord("Ctrl+Nothing"));
}

TEST_CASE("A script runs its commands in order") {
  TestWindow window;
  run_script(window,
             "# a chair\n"
             "new-template \"my chair\"\n"
             "\n"
             "add-part seat   # the seat\n"
             "set-position 0 0.1 0\r\n"
             "set-size 0.5 0.05 0.5\n"
             "set-rotation 0 90 0\n"
             "set-label 3\n"
             "must-exist yes\n"
             "set-existence 0.75");
  const PartTemplate& made = *window.studio().history.current().active_template();
  CHECK(made.name == "my chair");
  REQUIRE(made.parts.size() == 1);
  CHECK(made.parts[0].name == "seat");
  CHECK(made.parts[0].position.mean == Vec3(0, 0.1, 0));
  CHECK(made.parts[0].scale.mean == Vec3(0.5, 0.05, 0.5));
  CHECK(made.parts[0].orientation.angularDistance(Eigen::Quaterniond(std::sqrt(0.5), 0, std::sqrt(0.5), 0)) <
        1e-9);
  CHECK(made.parts[0].label == 3);
  CHECK(made.parts[0].must_exist);
  CHECK(made.parts[0].existence == doctest::Approx(0.75));
}

TEST_CASE("What is wrong with a script is said with file and line") {
  TestWindow window;
  CHECK(problem_of([&] { run_script(window, "wait\n\nmake-coffee\n"); }).find("test.txt, line 3") == 0);
  CHECK(problem_of([&] {
          run_script(window, "new-template\nadd-part\nset-position 1 2\n");
        }).find("test.txt, line 3") == 0);
  CHECK(problem_of([&] { run_script(window, "set-position 1 x 2\n"); }).find("\"x\"") != std::string::npos);
  CHECK(problem_of([&] { run_script(window, "new-template \"chair\n"); }).find("test.txt, line 1") == 0);
  CHECK(problem_of([&] { run_script(window, "open /nowhere/at/all\n"); }).find("/nowhere/at/all") !=
        std::string::npos);
  CHECK(problem_of([&] { run_script(window, "set theme purple\n"); }).find("dark, light") !=
        std::string::npos);
  CHECK(problem_of([&] { run_script(window, "delete-part\ndelete-part\n"); }).find("line 2") !=
        std::string::npos);
}

TEST_CASE("A script drags a part and prints how fast the fit followed") {
  TestWindow window;
  window.open_chairs(1);
  window.make_template();
  run_script(window, "clear-latency\nselect-part seat\ndrag-part 0 0.3 0 12\nreport-latency\nreport-fit\n");
  REQUIRE(window.studio().output.size() == 2);
  CHECK(window.studio().output[0].starts_with("latency: 12 edits"));
  CHECK(window.studio().output[1].starts_with("fit "));
  CHECK(window.studio().history.current().active_template()->parts[0].position.mean.y() ==
        doctest::Approx(0.2));
  CHECK(window.studio().history.entries().back().message == "Move seat");
}

TEST_CASE("A key is changed in the list of keys, given back, and taken from another command") {
  TestWindow window(1280, 1400);
  Studio& studio = window.studio();
  const auto key = [&](const char* name) { return key_of(studio, *find_command(studio, name)); };
  window.key("F1");
  window.click("key:add-shapes");
  window.key("Ctrl+Alt+L");
  CHECK(key("add-shapes") == "Ctrl+Alt+L");
  CHECK(studio.ui.status.find("key is Ctrl+Alt+L") != std::string::npos);  // it was not run
  window.key("Ctrl+Alt+L");
  CHECK(studio.ui.status.find("open a folder") != std::string::npos);
  window.click("key:Reset:add-shapes");
  CHECK(key("add-shapes").empty());
  CHECK(studio.settings.keys.empty());

  // Another command's: nothing changes before it is taken.
  window.click("key:add-shapes");
  window.key("Ctrl+Shift+S");
  CHECK(studio.ui.key_change.taken_by == "save-as");
  CHECK(key("save-as") == "Ctrl+Shift+S");
  window.click("key:Cancel:add-shapes");
  CHECK(key("add-shapes").empty());
  window.click("key:add-shapes");
  window.key("Ctrl+Shift+S");
  window.click("key:Take it:add-shapes");
  CHECK(key("add-shapes") == "Ctrl+Shift+S");
  CHECK(key("save-as").empty());
  window.click("key:Reset:save-as");
  CHECK(key("save-as") == "Ctrl+Shift+S");
  CHECK(key("add-shapes").empty());

  window.click("key:undo");
  window.key("Escape");
  CHECK(studio.ui.key_change.command.empty());
  CHECK(studio.ui.help);
  window.click("key:undo");
  window.click("key:No key:undo");
  CHECK(key("undo").empty());
  window.key("Escape");
  CHECK_FALSE(studio.ui.help);
  CHECK(run_command(studio, "reset-keys"));
  CHECK(key("undo") == "Ctrl+Z");
}

TEST_CASE("A script sets keys, and is told what is wrong with one") {
  TestWindow window;
  Studio& studio = window.studio();
  const auto set = [&](const char* command, const char* key) {
    const std::string arguments[] = {command, key};
    return run_command(studio, "set-key", arguments);
  };
  CHECK(set("undo", "ctrl+u"));
  CHECK(studio.settings.keys.at("undo") == "Ctrl+U");
  CHECK_FALSE(set("redo", "Ctrl+U"));
  CHECK_FALSE(set("redo", "Hyper+X"));
  CHECK_FALSE(set("none", "Ctrl+U"));
  CHECK(set("undo", "Ctrl+Z"));
  CHECK(studio.settings.keys.empty());
}
