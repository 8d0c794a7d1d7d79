// Undo by snapshots: previews, commits, jumps, and the bound on memory.
#include "core/session/history.h"

#include <doctest/doctest.h>

#include <utility>

using namespace archetype;

namespace {

Document document_named(const std::string& name) {
  PartTemplate part_template;
  part_template.name = name;
  Document document;
  document.templates.push_back(std::make_shared<const PartTemplate>(part_template));
  return document;
}

}  // namespace

TEST_CASE("A document is compared by the value of its templates") {
  CHECK(document_named("a") == document_named("a"));
  CHECK_FALSE(document_named("a") == document_named("b"));
  CHECK_FALSE(document_named("a") == Document{});
}

TEST_CASE("Commit, undo, redo and jump walk through the steps") {
  History history({}, "Start");
  CHECK_FALSE(history.can_undo());
  CHECK_FALSE(history.undo());
  CHECK(history.commit(document_named("a"), "A"));
  CHECK(history.commit(document_named("b"), "B"));
  CHECK(history.entries().size() == 3);
  CHECK(history.undo());
  CHECK(history.current() == document_named("a"));
  CHECK(history.redo());
  CHECK(history.current() == document_named("b"));
  CHECK_FALSE(history.redo());
  history.jump(0);
  CHECK(history.current() == Document{});
  CHECK_THROWS(history.jump(3));
}

TEST_CASE("A commit after an undo drops what could be redone") {
  History history({}, "Start");
  history.commit(document_named("a"), "A");
  history.undo();
  history.commit(document_named("b"), "B");
  CHECK_FALSE(history.can_redo());
  CHECK(history.entries().size() == 2);
  CHECK(history.entries()[1].message == "B");
}

TEST_CASE("A commit that changes nothing makes no step") {
  History history(document_named("a"), "Start");
  CHECK_FALSE(history.commit(document_named("a"), "Nothing"));
  CHECK(history.entries().size() == 1);
}

TEST_CASE("A preview is shown but is no step; the commit of a drag is one") {
  History history(document_named("a"), "Start");
  history.preview(document_named("b"));
  history.preview(document_named("c"));
  CHECK(history.current() == document_named("c"));
  CHECK(history.committed() == document_named("a"));
  CHECK(history.entries().size() == 1);
  SUBCASE("cancelled") {
    history.cancel_preview();
    CHECK(history.current() == document_named("a"));
  }
  SUBCASE("undone: only the preview goes") {
    CHECK(history.undo());
    CHECK(history.current() == document_named("a"));
    CHECK(history.entries().size() == 1);
  }
  SUBCASE("committed") {
    const std::uint64_t shown = history.revision();
    CHECK(history.commit(document_named("c"), "Drag"));
    CHECK(history.revision() != shown);
    CHECK(history.entries().size() == 2);
    CHECK_FALSE(history.has_preview());
  }
}

TEST_CASE("The revision tells every change of what is shown") {
  History history(document_named("a"), "Start");
  std::uint64_t last = history.revision();
  const auto changed = [&] { return std::exchange(last, history.revision()) != history.revision(); };
  CHECK_FALSE(changed());
  history.preview(document_named("b"));
  CHECK(changed());
  history.preview(document_named("b"));
  CHECK_FALSE(changed());
  history.commit(document_named("a"), "Back where it was");
  CHECK(changed());
  history.commit(document_named("c"), "C");
  CHECK(changed());
  history.undo();
  CHECK(changed());
}

TEST_CASE("The oldest steps are forgotten, by number and by bytes") {
  SUBCASE("number") {
    History history({}, "Start", {.entries = 3});
    for (int i = 0; i < 10; ++i) history.commit(document_named(std::to_string(i)), "Step");
    CHECK(history.entries().size() == 3);
    CHECK(history.current() == document_named("9"));
    CHECK(history.undo());
    CHECK(history.undo());
    CHECK_FALSE(history.undo());
    CHECK(history.current() == document_named("7"));
  }
  SUBCASE("bytes: the current state always stays") {
    History history({}, "Start", {.bytes = 10'000});
    for (int i = 0; i < 10; ++i)
      history.commit(document_named(std::string(4000, static_cast<char>('a' + i))), "Step");
    CHECK(history.entries().size() == 2);
    CHECK(history.current() == document_named(std::string(4000, 'j')));
  }
}
