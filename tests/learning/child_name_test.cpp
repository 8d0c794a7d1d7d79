#include "core/learning/child_name.h"

#include <doctest/doctest.h>

using namespace archetype;

TEST_CASE("a child has the next free number of its family") {
  CHECK(child_name("chair", {"chair"}) == "chair 2");
  CHECK(child_name("chair", {"chair", "chair 2", "chair 4"}) == "chair 3");
  CHECK(child_name("chair 2", {"chair", "chair 2"}) == "chair 3");
  CHECK(child_name("swivel chair 12", {"swivel chair", "swivel chair 12"}) == "swivel chair 2");
}

TEST_CASE("a number that a person gave is no child's") {
  CHECK(child_name("type 10", {"type 10", "chair"}) == "type 10 2");
  CHECK(child_name("747", {"747"}) == "747 2");
  CHECK(child_name(" 2", {" 2"}) == " 2 2");
  CHECK(child_name("", {""}) == " 2");
}
