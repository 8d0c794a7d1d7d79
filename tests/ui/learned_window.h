// A window in which was learned.
#pragma once

#include <doctest/doctest.h>

#include "core/session/learn_templates.h"
#include "tests/ui/test_window.h"

namespace archetype::test {

// Chairs from which was learned, with the panel in sight.
struct LearnedWindow : TestWindow {
  explicit LearnedWindow(std::size_t chairs = 4) {
    open_chairs(chairs);
    make_template();
    click("command:learn");
    settle();
    REQUIRE(studio().collection.content.learning);
    REQUIRE_FALSE(studio().collection.content.learning->steps.empty());
  }
  const LearningRecord& record() { return *studio().collection.content.learning; }
  const History& history() { return studio().history; }
};

}  // namespace archetype::test
