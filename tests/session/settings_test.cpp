// Settings survive broken files, and say what is wrong with a value.
#include "core/session/settings.h"

#include <doctest/doctest.h>

#include <fstream>

#include "core/io/file.h"
#include "tests/support/scratch_folder.h"

using namespace archetype;
using archetype::test::ScratchFolder;

TEST_CASE("Settings come back as they were saved") {
  const ScratchFolder scratch;
  const auto path = scratch.path() / "deep" / "settings.json";
  Settings settings;
  settings.theme = "light";
  settings.ui_scale = 1.5;
  settings.left_width = 444;
  settings.show_bottom = false;
  settings.keys["undo"] = "Ctrl+U";
  remember_recent(settings, "/a");
  remember_recent(settings, "/b");
  remember_recent(settings, "/a");
  CHECK(settings.recent == std::vector<std::string>{"/a", "/b"});
  save_settings(path, settings);
  const LoadedSettings loaded = load_settings(path);
  CHECK(loaded.problem.empty());
  CHECK(loaded.settings == settings);
}

TEST_CASE("No file means the defaults; a broken one the defaults and a message") {
  const ScratchFolder scratch;
  CHECK(load_settings(scratch.path() / "none.json").problem.empty());
  for (const char* text : {"", "{", "[]", "null", "{\"recent\": 5}", "{\"keys\": []}", "\xff\xfe"}) {
    CAPTURE(text);
    const LoadedSettings loaded = load_settings(scratch.write("settings.json", text));
    CHECK(loaded.settings == Settings{});
    CHECK(loaded.problem.find("settings.json") != std::string::npos);
  }
}

TEST_CASE("One bad value does not spoil the others") {
  const ScratchFolder scratch;
  const auto path =
      scratch.write("settings.json", R"({"ui_scale": 99, "theme": "light", "recent": ["/a", 3]})");
  const LoadedSettings loaded = load_settings(path);
  CHECK(loaded.settings.theme == "light");
  CHECK(loaded.settings.ui_scale == 0);
  CHECK(loaded.settings.recent == std::vector<std::string>{"/a"});
  CHECK(loaded.problem.find("ui_scale") != std::string::npos);
}

TEST_CASE("A setting is set by name, and what is wrong is said with what is expected") {
  Settings settings;
  CHECK(set_setting(settings, "theme", "light").empty());
  CHECK(settings.theme == "light");
  CHECK(set_setting(settings, "threads", "4").empty());
  CHECK(settings.threads == 4);
  CHECK(set_setting(settings, "show_bottom", "false").empty());
  CHECK_FALSE(settings.show_bottom);
  const Settings before = settings;
  CHECK(set_setting(settings, "theme", "pink").find("dark, light") != std::string::npos);
  CHECK(set_setting(settings, "threads", "many").find("0 to 1024") != std::string::npos);
  CHECK(set_setting(settings, "threads", "1e999") != "");
  for (const char* scale : {"0.01", "-1", "4.5", "large"})
    CHECK(set_setting(settings, "ui_scale", scale).find("0 or a number from 0.5 to 4") != std::string::npos);
  CHECK(set_setting(settings, "nothing", "1").find("ui_scale") != std::string::npos);
  CHECK(settings == before);
}

TEST_CASE("A setting that was for one run is put back alone") {
  const Settings before;
  Settings settings;
  settings.theme = "light";
  settings.ui_scale = 2;
  settings.show_bottom = false;
  copy_setting(settings, before, "theme");
  copy_setting(settings, before, "no such setting");
  CHECK(settings.theme == before.theme);
  CHECK(settings.ui_scale == 2);
  CHECK_FALSE(settings.show_bottom);
}
