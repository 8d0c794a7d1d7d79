// The document as text in the project file.
#include "core/session/document_text.h"

#include <doctest/doctest.h>

#include "core/base/error.h"

using namespace archetype;

TEST_CASE("A document comes back as it was") {
  Document document;
  CHECK(parse_document(format_document(document), "p") == document);
  PartTemplate chair;
  chair.name = "chair";
  chair.parts.resize(2);
  chair.parts[0].name = "seat";
  chair.parts[1].name = "back";
  chair.parts[1].position.mean = Vec3(0.1, -1.0 / 3, 2e-17);
  chair.parts[1].must_exist = true;
  document.templates.push_back(std::make_shared<const PartTemplate>(chair));
  chair.name = "bench";
  document.templates.push_back(std::make_shared<const PartTemplate>(chair));
  document.active = 1;
  CHECK(parse_document(format_document(document), "p") == document);
}

TEST_CASE("A text that is none says which file it was in") {
  for (const char* text :
       {"", "{", "[]", "{}", R"({"format":"archetype-document","templates":5})",
        R"({"format":"archetype-document","templates":[{"parts":3}]})", R"({"format":7})"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_document(text, "some.archetype"), InputError);
  }
}
