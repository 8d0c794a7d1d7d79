// Every command that says that it edits, whichever they are: done, undone, redone; and ten thousand of them
// at random, undone to the start.
#include <doctest/doctest.h>

#include <map>

#include "core/base/random.h"
#include "core/session/actions.h"
#include "tests/ui/test_window.h"
#include "ui/inspect_actions.h"
#include "ui/selection.h"

using namespace archetype;
using archetype::test::TestWindow;

namespace {

using Text = std::vector<std::string>;

// A template of linked legs, a seat and a back, then one of nothing but a seat; a template file.
void make_document(TestWindow& window) {
  Studio& studio = window.studio();
  window.make_template();
  add_mirror_images(studio.history, {2}, 0);
  PartTemplate stool = *studio.history.committed().active_template();
  stool.name = "stool";
  stool.parts.resize(1);
  add_template(studio.history, stool, "Stool");
  select_template(studio.history, 0);
  const Text path{(window.scratch().path() / "t.json").string()};
  REQUIRE(run_command(studio, "save-template", path));
  select_only(studio.ui, 0);
}

// What else a command needs to be usable, besides a template whose first part is selected.
void prepare(TestWindow& window, std::string_view command) {
  Studio& studio = window.studio();
  if (command == "mirror-part") {
    unlink_parts(studio.history, {2});
    select_only(studio.ui, 2);
  }
  if (command == "unlink-parts") select_only(studio.ui, 2);
  if (command == "merge-parts" || command == "link-parts") select_all_of(studio.ui, {0, 1});
  if (command == "paste-parts") REQUIRE(run_command(studio, "copy-parts"));
  if (command == "template-up") select_template(studio.history, 1);
  if (command == "forget-features") {
    PartTemplate learned = *studio.history.committed().active_template();
    learned.parts[0].has_features = true;
    add_template(studio.history, learned, "Learned");
  }
  if (command == "take-look") look_at(studio, *studio.history.committed().active_template(), "round 1");
  if (command == "take-suggestion")
    studio.ui.suggestions.push_back(
        {{.part_template = *studio.history.committed().active_template()}, nullptr});
  if (command == "pin-shown") {
    REQUIRE(run_command(studio, "fit-all"));
    REQUIRE(run_command(studio, "show-inspect"));
    window.settle();
  }
  if (command == "free-yaw" || command == "clear-corrections")
    pin_yaw(studio.history, shape_in_view(studio), 1);
  if (command == "unmark-outlier")
    mark_shapes(studio.history, std::vector{shape_in_view(studio)}, ShapeMark::outlier);
  if (command == "free-template") pin_template(studio.history, shape_in_view(studio), "chair");
  if (command == "free-points")
    pin_samples(studio.history, shape_in_view(studio), {}, std::vector<std::uint32_t>{1, 2}, "seat");
  if (command.ends_with("points")) {
    studio.ui.points.selected = {1, 2, 3, 50};
    studio.ui.points.shape_revision = studio.shape.shape_revision;
  }
  if (command == "shrink-to-points") studio.ui.points.selected.clear();
}

Text arguments_of(const TestWindow& window, std::string_view command) {
  static const std::map<std::string_view, Text> known{{"start-template", {"chair"}},
                                                      {"select-template", {"stool"}},
                                                      {"rename-template", {"armchair"}},
                                                      {"rename-part", {"cushion"}},
                                                      {"set-position", {"0.1", "0.2", "0.3"}},
                                                      {"set-size", {"0.1", "0.2", "0.3"}},
                                                      {"set-rotation", {"10", "20", "30"}},
                                                      {"set-position-spread", {"0.1", "0.1", "0.3"}},
                                                      {"set-size-spread", {"0.3", "0.1", "0.2"}},
                                                      {"set-label", {"9"}},
                                                      {"set-colour", {"5"}},
                                                      {"set-existence", {"0.5"}},
                                                      {"pin-yaw", {"90"}},
                                                      {"pin-template", {"stool"}},
                                                      {"take-suggestion", {"1"}}};
  if (command == "load-template") return {(window.scratch().path() / "t.json").string()};
  const auto found = known.find(command);
  return found == known.end() ? Text{} : found->second;
}

}  // namespace

TEST_CASE("Every editing command is one step: done, undone and redone") {
  for (const Command& command : all_commands()) {
    if (!command.edits) continue;
    CAPTURE(command.name);
    TestWindow window;
    Studio& studio = window.studio();
    bool needs_shape = command.name == "adopt-fit" || command.name == "learn-features" ||
                       command.name == "clear-corrections";
    for (const char* end :
         {"points", "-yaw", "pin-template", "free-template", "-shown", "-outlier", "learn-from-shape"})
      needs_shape = needs_shape || command.name.ends_with(end);
    if (needs_shape) window.open_chairs(1);
    make_document(window);
    window.settle();
    prepare(window, command.name);
    const Document before = studio.history.current();
    const std::size_t position = studio.history.position();
    CHECK(run_command(studio, command.name, arguments_of(window, command.name)));
    const Document after = studio.history.current();
    CHECK_FALSE(after == before);
    CHECK_FALSE(studio.history.has_preview());
    REQUIRE(studio.history.position() == position + 1);
    CHECK_FALSE(studio.history.entries().back().message.empty());
    window.frames(2);
    window.key("Ctrl+Z");
    CHECK(studio.history.current() == before);
    window.key("Ctrl+Shift+Z");
    CHECK(studio.history.current() == after);
  }
}

TEST_CASE("Commands that do not say that they edit leave the document alone") {
  TestWindow window;
  make_document(window);
  const Document before = window.studio().history.current();
  for (const Command& command : window.studio().commands) {
    if (command.edits || !command.arguments.empty() || command.name == "undo" || command.name == "redo")
      continue;
    if (command.name == "quit" || command.name == "open-seats" || command.name.starts_with("generate"))
      continue;
    CAPTURE(command.name);
    select_all_of(window.studio().ui, {0, 1});
    run_command(window.studio(), command.name);
    window.frames();
    CHECK(window.studio().history.current() == before);
    window.key("Escape");
    window.studio().wanted_picture.reset();
  }
}

TEST_CASE("Ten thousand random edits are undone to the first document, in bounded memory") {
  TestWindow window;
  make_document(window);
  Studio& studio = window.studio();
  studio.history = History(studio.history.current(), "Start");
  const Document first = studio.history.current();
  std::vector<const Command*> edits;
  for (const Command& command : studio.commands)
    if (command.edits && command.name != "take-suggestion" && command.name != "take-look")
      edits.push_back(&command);
  RandomStream random(11);
  const auto below = [&](std::size_t count) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  };
  std::map<std::string_view, int> made;
  for (int round = 0; round < 10'000; ++round) {
    const PartTemplate* active = studio.history.current().active_template();
    const std::size_t parts = active ? active->parts.size() : 0;
    PartList selection;
    for (std::size_t i = 0; i < parts; ++i)
      if (below(3) == 0) selection.push_back(i);
    select_all_of(studio.ui, selection);
    const Command* command = edits[below(edits.size())];
    // It would soon be full, and then nearly all of them be refused.
    if (parts > 14) command = find_command(studio, "delete-part");
    if (studio.history.current().templates.size() > 6) command = find_command(studio, "delete-template");
    const std::size_t position = studio.history.position();
    Text arguments = arguments_of(window, command->name);
    for (std::string& argument : arguments)
      if (argument.starts_with("0.")) argument = std::to_string(0.01 + 0.9 * random.uniform());
    const Document before = studio.history.current();
    run_command(studio, command->name, arguments);
    REQUIRE(studio.history.position() <= position + 1);
    if (studio.history.position() == position)
      CHECK(studio.history.current() == before);
    else
      ++made[command->name];
    if (round % 50 == 0) {
      const Document after = studio.history.current();
      if (studio.history.undo()) studio.history.redo();
      CHECK(studio.history.current() == after);
    }
  }
  CHECK(made.size() > 20);
  CHECK(studio.history.position() > 4'000);
  std::size_t steps = 0;
  while (run_command(studio, "undo")) ++steps;
  CHECK(studio.history.current() == first);
  MESSAGE(steps << " steps of " << made.size() << " commands");
  while (studio.history.redo()) --steps;
  CHECK(steps == 0);
}
