// The document as text in the project file.
#include "core/session/document_text.h"

#include <doctest/doctest.h>

#include "core/base/error.h"
#include "core/io/template_file.h"

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

TEST_CASE("Nesting that could overflow the stack is refused, whatever a template file may hold is not") {
  const std::string deep(200'000, '[');
  CHECK_THROWS_AS(parse_document(R"({"format":"archetype-document","templates":[)" + deep, "p"), InputError);
  const std::string nested = std::string(62, '[') + std::string(62, ']');
  const PartTemplate deepest = parse_template(
      R"({"format":"archetype-template","version":1,"name":"a","parts":[],"more":)" + nested + "}", "a.json");
  const Document document{{std::make_shared<const PartTemplate>(deepest)}, 0};
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
