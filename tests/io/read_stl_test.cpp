#include <doctest/doctest.h>

#include <bit>

#include "tests/io/gltf_builder.h"
#include "tests/io/shape_reading.h"

using namespace archetype;
using namespace archetype::test;

namespace {

// A binary STL of triangles given as nine coordinates each.
std::string binary_stl(std::string header, const std::vector<std::array<float, 9>>& facets) {
  header.resize(80, ' ');
  append_word(header, static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    for (int i = 0; i < 3; ++i) append_word(header, std::bit_cast<std::uint32_t>(std::nanf("")));
    for (const float x : facet) append_word(header, std::bit_cast<std::uint32_t>(x));
    header += std::string(2, '\7');
  }
  return header;
}

const std::vector<std::array<float, 9>> two_and_a_duplicate{{0, 0, 0, 1, 0, 0, 1, 1, 0},
                                                            {0, 0, 0, 1, 1, 0, 0, 1, 0},
                                                            {0, 0, 0, 1, 0, 0, 1, 1, 0},
                                                            {0, -0.F, 0, 0, 0, 0, 1, 0, 0}};
const Faces welded{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 0, 1}};

}  // namespace

TEST_CASE("binary STL joins equal corners and keeps all facets, also where it begins with solid") {
  for (const char* header : {"made by a scanner", "solid not ASCII at all", "solid facet normal 0 0 0"}) {
    CAPTURE(header);
    const ShapeFile shape = read_as("a.stl", binary_stl(header, two_and_a_duplicate));
    CHECK(faces(shape.mesh) == welded);
    CHECK(shape.mesh.vertices.size() == 4);
    CHECK(shape.warnings.size() == 1);  // the degenerate facet
    const ShapeFile longer = read_as("a.stl", binary_stl(header, two_and_a_duplicate) + std::string(3, '\0'));
    CHECK(faces(longer.mesh) == welded);
    CHECK(longer.warnings.size() == 2);
  }
}

TEST_CASE("ASCII STL reads the same, in any case and layout") {
  std::string text = "solid a name with facet in it\n";
  for (const auto& f : two_and_a_duplicate) {
    text += "facet normal nan nan nan\n outer loop\n";
    for (std::size_t c = 0; c < 9; c += 3) {
      text += "  vertex " + std::to_string(f[c]) + " " + std::to_string(f[c + 1]) + " " +
              std::to_string(f[c + 2]) + "\n";
    }
    text += " endloop\nendfacet\n";
  }
  CHECK(faces(read_as("a.stl", text + "endsolid\n").mesh) == welded);
  CHECK(read_as("a.stl", text + "endsolid\n").warnings.size() == 1);
  CHECK(read_as("a.stl", text).warnings.size() == 2);  // cut off, perhaps

  std::string upper;
  for (const char c : text + "ENDSOLID a\nsolid b\nendsolid")
    upper += c == '\n' ? '\r' : static_cast<char>(std::toupper(c));
  CHECK(faces(read_as("a.STL", upper).mesh) == welded);

  const ShapeFile sloppy =
      read_as("a.stl", "solid\nfacet vertex 0 0 0 vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 endfacet endsolid");
  CHECK(faces(sloppy.mesh) == Faces{{0, 1, 2, 3}});
  CHECK(sloppy.warnings.size() == 1);
}
