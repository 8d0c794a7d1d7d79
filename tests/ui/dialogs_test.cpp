// Windows that stand over the panels: what lies behind them keeps quiet.
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <functional>

#include "tests/ui/test_window.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

std::size_t tooltips_seen() {
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  return static_cast<std::size_t>(std::count_if(windows.begin(), windows.end(), [](const ImGuiWindow* each) {
    return (each->Flags & ImGuiWindowFlags_Tooltip) && each->Active && !each->Hidden;
  }));
}

// Rests with the mouse on what is outermost, so that no dialog lies over it.
void rest_on(TestWindow& window, const std::string& target) {
  for (const Target& each : window.studio().targets)
    if (each.name == target)
      ImGui::GetIO().MousePos = {(each.low_x + each.high_x) / 2, (each.low_y + each.high_y) / 2};
  window.frames(4);
}

struct Dialog {
  std::string name;
  std::function<void(Studio&)> open;
  std::function<void(Studio&)> close;
};

const std::vector<Dialog> dialogs{
    {"palette", [](Studio& s) { run_command(s, "palette"); }, [](Studio& s) { s.ui.palette.open = false; }},
    {"keys", [](Studio& s) { run_command(s, "keys"); }, [](Studio& s) { s.ui.help = false; }},
    {"about", [](Studio& s) { run_command(s, "about"); }, [](Studio& s) { s.ui.about = false; }},
    {"files", [](Studio& s) { run_command(s, "open-folder"); }, [](Studio& s) { s.ui.browser = {}; }},
    {"suggestions", [](Studio& s) { s.ui.show_suggestions = true; },
     [](Studio& s) { s.ui.show_suggestions = false; }},
    {"save question", [](Studio& s) { run_command(s, "quit"); }, [](Studio& s) { s.ui.closing = {}; }}};

}  // namespace

TEST_CASE("Nothing behind a dialog shows a tooltip over it") {
  TestWindow window;
  window.open_chairs(2);
  window.make_template();  // not saved: closing asks
  for (const std::string target : {"cell:chair_00000", "command:undo"}) {
    CAPTURE(target);
    rest_on(window, target);
    REQUIRE(tooltips_seen() == 1);
    for (const Dialog& dialog : dialogs) {
      CAPTURE(dialog.name);
      dialog.open(window.studio());
      for (int frame = 0; frame < 4; ++frame) {
        window.frames();
        CHECK(tooltips_seen() == 0);
      }
      dialog.close(window.studio());
      window.frames(4);
      rest_on(window, target);
      CHECK(tooltips_seen() == 1);
    }
  }
}

TEST_CASE("What a dialog says of its own is still shown") {
  TestWindow window;
  REQUIRE(run_command(window.studio(), "keys"));
  window.frames(3);
  rest_on(window, "key:open-folder");
  CHECK(window.studio().ui.help);
  CHECK(tooltips_seen() == 1);
}
